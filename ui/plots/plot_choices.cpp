// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/with.h"
#include "ui/plots/plot_grid.h"

#include <QActionGroup>

namespace slidercrank
{

void PlotGrid::makeChoices()
{
    const auto add = [this](const QString &text, auto PlotSettings::*member, auto on, auto off) {
        auto *action = new QAction(text, this);
        action->setCheckable(true);
        m_choices << action;
        connect(action, &QAction::triggered, this,
                [this, member, on, off](bool checked) { setSettings(with(settings(), member, checked ? on : off)); });
        connect(this, &PlotGrid::settingsChanged, action,
                [action, member, on](const PlotSettings &settings) { action->setChecked(settings.*member == on); });
    };
    auto *measures = new QActionGroup(this);
    const auto addMeasure = [&](const QString &text, ErrorMeasure measure) {
        add(text, &PlotSettings::error, measure, measure);
        measures->addAction(m_choices.back());
    };
    addMeasure(tr("Error in &% of the reference"), ErrorMeasure::Percent);
    addMeasure(tr("Error &in ° and mm"), ErrorMeasure::Absolute);
    addMeasure(tr("Error in % of the &peak"), ErrorMeasure::OfPeak);
    add(tr("&Logarithmic errors"), &PlotSettings::logarithmicError, true, false);
    add(tr("File's &rounding as a band"), &PlotSettings::roundingBand, true, false);
    add(tr("Over the crank &angle"), &PlotSettings::abscissa, Abscissa::CrankAngle, Abscissa::Time);
    auto *measuring = new QAction(tr("Mea&suring cursors"), this);
    measuring->setObjectName(QStringLiteral("measuringAction"));
    measuring->setCheckable(true);
    m_choices << measuring;
    connect(measuring, &QAction::toggled, this, &PlotGrid::setMeasuring);
}

} // namespace slidercrank
