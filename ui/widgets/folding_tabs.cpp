// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/folding_tabs.h"

#include <QSignalBlocker>
#include <QTabBar>

namespace slidercrank
{

FoldingTabs::FoldingTabs(QWidget *parent)
    : QTabWidget(parent)
{
    setDocumentMode(true);
    setFocusPolicy(Qt::NoFocus); // only the bar is a stop of the Tab key; this would pass on to it
    tabBar()->setFocusPolicy(Qt::TabFocus);
    tabBar()->setObjectName(QStringLiteral("tabBar"));
    tabBar()->setDrawBase(false);
    tabBar()->setAccessibleName(tr("Panels"));
    tabBar()->setToolTip(tr("F9 hides and shows the panels"));
    connect(this, &QTabWidget::tabBarClicked, this, [this](int index) {
        if (index >= 0) {
            setFolded(false);
        }
    });
    connect(this, &QTabWidget::currentChanged, this, &FoldingTabs::makePage);
}

void FoldingTabs::addPage(const std::function<QWidget *()> &make, const QString &title)
{
    m_unmade[count()] = make;
    addPage(new QWidget(this), title);
}

void FoldingTabs::makePage(int index)
{
    const auto unmade = m_unmade.find(index);
    if (unmade == m_unmade.end()) {
        return;
    }
    const std::function<QWidget *()> make = unmade->second;
    m_unmade.erase(unmade);
    const QSignalBlocker quiet(this);
    const QString title = tabText(index);
    QWidget *placeholder = widget(index);
    insertTab(index, make(), title);
    setCurrentIndex(index);
    delete placeholder;
}

void FoldingTabs::setTitle(QWidget *page, const QString &title)
{
    const int index = indexOf(page);
    if (tabText(index) != title) { // the bar would lay out the whole window again
        setTabText(index, title);
    }
}

void FoldingTabs::showPage(QWidget *page)
{
    setCurrentWidget(page);
    setFolded(false);
}

void FoldingTabs::setFolded(bool folded)
{
    if (folded == m_isFolded) {
        return;
    }
    m_isFolded = folded;
    const int bar = tabBar()->sizeHint().height();
    setMinimumHeight(folded ? bar : 0);
    setMaximumHeight(folded ? bar : QWIDGETSIZE_MAX);
    emit foldedChanged(folded);
}

} // namespace slidercrank
