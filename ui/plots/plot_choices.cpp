// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_choices.h"

#include "ui/plots/plot_grid.h"

#include <QActionGroup>

namespace slidercrank
{

QList<QAction *> plotChoices(PlotGrid &grid)
{
    QList<QAction *> choices;
    const auto add = [&](const QString &text, auto PlotSettings::*member, auto on, auto off) {
        auto *action = new QAction(text, &grid);
        action->setCheckable(true);
        choices << action;
        QObject::connect(action, &QAction::triggered, &grid, [&grid, member, on, off](bool checked) {
            PlotSettings settings = grid.settings();
            settings.*member = checked ? on : off;
            grid.setSettings(settings);
        });
        QObject::connect(&grid, &PlotGrid::settingsChanged, action, [action, member, on](const PlotSettings &settings) {
            action->setChecked(settings.*member == on);
        });
    };
    auto *measures = new QActionGroup(&grid);
    const auto addMeasure = [&](const QString &text, ErrorMeasure measure) {
        add(text, &PlotSettings::error, measure, measure);
        measures->addAction(choices.back());
    };
    addMeasure(PlotGrid::tr("Error in &% of the reference"), ErrorMeasure::Percent);
    addMeasure(PlotGrid::tr("Error &in ° and mm"), ErrorMeasure::Absolute);
    addMeasure(PlotGrid::tr("Error in % of the &peak"), ErrorMeasure::OfPeak);
    add(PlotGrid::tr("&Logarithmic errors"), &PlotSettings::logarithmicError, true, false);
    add(PlotGrid::tr("File's &rounding as a band"), &PlotSettings::roundingBand, true, false);
    add(PlotGrid::tr("Over the crank &angle"), &PlotSettings::abscissa, Abscissa::CrankAngle, Abscissa::Time);
    auto *measuring = new QAction(PlotGrid::tr("Mea&suring cursors"), &grid);
    measuring->setObjectName(QStringLiteral("measuringAction"));
    measuring->setCheckable(true);
    choices << measuring;
    QObject::connect(measuring, &QAction::toggled, &grid, &PlotGrid::setMeasuring);
    return choices;
}

} // namespace slidercrank
