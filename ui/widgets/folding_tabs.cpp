// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/folding_tabs.h"

#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

namespace slidercrank
{

FoldingTabs::FoldingTabs(QWidget *parent)
    : QWidget(parent)
    , m_bar(new QTabBar(this))
    , m_pages(new QStackedWidget(this))
{
    m_bar->setObjectName(QStringLiteral("tabBar"));
    m_bar->setDrawBase(false);
    m_bar->setExpanding(false);
    m_bar->setAccessibleName(tr("Panels"));
    m_bar->setToolTip(tr("F9 hides and shows the panels"));

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_bar);
    column->addWidget(m_pages, 1);

    connect(m_bar, &QTabBar::tabBarClicked, this, [this](int index) {
        if (index >= 0) {
            setFolded(false);
        }
    });
    connect(m_bar, &QTabBar::currentChanged, this, &FoldingTabs::showCurrent);
}

void FoldingTabs::addPage(QWidget *page, const QString &title)
{
    m_pages->addWidget(page);
    m_bar->addTab(title);
}

void FoldingTabs::addPage(const std::function<QWidget *()> &make, const QString &title)
{
    m_unmade[m_pages->count()] = make;
    addPage(new QWidget(this), title);
}

void FoldingTabs::showCurrent()
{
    const int index = m_bar->currentIndex();
    if (const auto unmade = m_unmade.find(index); unmade != m_unmade.end()) {
        QWidget *placeholder = m_pages->widget(index);
        m_pages->insertWidget(index, unmade->second());
        delete placeholder;
        m_unmade.erase(unmade);
    }
    m_pages->setCurrentIndex(index);
}

void FoldingTabs::setTitle(QWidget *page, const QString &title)
{
    const int index = m_pages->indexOf(page);
    if (m_bar->tabText(index) != title) { // the bar would lay the whole window out anew
        m_bar->setTabText(index, title);
    }
}

void FoldingTabs::showPage(QWidget *page)
{
    m_bar->setCurrentIndex(m_pages->indexOf(page));
    setFolded(false);
}

int FoldingTabs::indexOf(QWidget *page) const
{
    return m_pages->indexOf(page);
}

int FoldingTabs::current() const
{
    return m_bar->currentIndex();
}

void FoldingTabs::setCurrent(int index)
{
    m_bar->setCurrentIndex(index);
}

bool FoldingTabs::isFolded() const
{
    return m_pages->isHidden();
}

void FoldingTabs::setFolded(bool folded)
{
    if (folded == isFolded()) {
        return;
    }
    m_pages->setHidden(folded);
    setMaximumHeight(folded ? m_bar->sizeHint().height() : QWIDGETSIZE_MAX); // the rest goes to the neighbour
    emit foldedChanged(folded);
}

} // namespace slidercrank
