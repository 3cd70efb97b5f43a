// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/folding_tabs.h"

#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

namespace slidercrank
{

FoldingTabs::FoldingTabs(QWidget *parent)
    : QTabWidget(parent)
{
    setDocumentMode(true);
    setFocusPolicy(Qt::NoFocus); // otherwise the Tab key would stop at this widget and at its bar
    tabBar()->setFocusPolicy(Qt::TabFocus);
    tabBar()->setObjectName("tabBar");
    tabBar()->setDrawBase(false);
    tabBar()->setAccessibleName(tr("Panels"));
    tabBar()->setToolTip(tr("F9 hides and shows the panels"));
    connect(this, &QTabWidget::tabBarClicked, this, [this](int index) {
        if (index >= 0) {
            setFolded(false);
        }
    });
    connect(this, &QTabWidget::currentChanged, this, &FoldingTabs::makeContent);
}

void FoldingTabs::addPage(const QString &title, const std::function<QWidget *()> &make)
{
    m_unmade[count()] = make;
    addTab(new QWidget, title);
}

void FoldingTabs::makeContent(int index)
{
    if (const auto make = m_unmade.take(index)) {
        auto *layout = new QVBoxLayout(widget(index));
        layout->setContentsMargins(0, 0, 0, 0);
        layout->addWidget(make());
    }
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
    findChild<QStackedWidget *>()->setVisible(!folded); // the Tab key must not lead into hidden pages
    emit foldedChanged(folded);
}

} // namespace slidercrank

#include "moc_folding_tabs.cpp"
