// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/rooms.h"

#include "ui/controls/folding_tabs.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/timeline.h"
#include "ui/plots/plot_grid.h"

#include <QSplitter>
#include <QVBoxLayout>

namespace slidercrank
{

namespace
{

constexpr int kPanelHeight = 230; // px: the table of six channels with its sentence

} // namespace

QSplitter *columnsOf(const Rooms &rooms)
{
    auto *left = new QWidget;
    auto *leftColumn = new QVBoxLayout(left);
    leftColumn->setContentsMargins(6, 6, 3, 6);
    leftColumn->addWidget(rooms.mechanism, 1);
    leftColumn->addWidget(rooms.timeline);
    leftColumn->addWidget(rooms.parameters);
    left->setMinimumWidth(340);

    auto *right = new QSplitter(Qt::Vertical);
    right->setObjectName(QStringLiteral("plotsAndTabs"));
    right->addWidget(rooms.plots);
    right->addWidget(rooms.tabs);
    right->setStretchFactor(0, 1);
    right->setStretchFactor(1, 0);
    right->setChildrenCollapsible(false);
    right->setSizes({600, kPanelHeight});
    QObject::connect(rooms.tabs, &FoldingTabs::foldedChanged, right, [right](bool folded) {
        const int all = right->sizes().value(0) + right->sizes().value(1);
        right->setSizes(folded ? QList<int>{all, 0} : QList<int>{all - kPanelHeight, kPanelHeight});
    });

    auto *columns = new QSplitter(Qt::Horizontal);
    columns->setObjectName(QStringLiteral("columns"));
    columns->addWidget(left);
    columns->addWidget(right);
    columns->setStretchFactor(0, 0);
    columns->setStretchFactor(1, 1);
    columns->setChildrenCollapsible(false);
    columns->setSizes({430, 970});
    return columns;
}

} // namespace slidercrank
