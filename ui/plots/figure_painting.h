// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The figure, or one plot of it, in a size: each plot with the room that its labels take; and painted, for any device.

#include "ui/plots/plot_arrangement.h"
#include "ui/plots/plot_figure.h"
#include "ui/text/theme.h"

#include <QMargins>
#include <QRect>

#include <array>
#include <optional>

class QPainter;

namespace slidercrank
{

struct PlacedPlot {
    QRect cell;
    QMargins margins;
    PlotPicture picture;
};

/// Those whose cells are empty cost nothing.
std::array<PlacedPlot, kPlotCount> placedPlots(PlotFigure &figure, const PlotArrangement &arrangement,
                                               const PlotTypography &typography);

/// With legend and background, and a line at that instant (s). Every curve ends at its axes, also on devices that do
/// not clip.
void paintPlots(QPainter &painter, PlotFigure &figure, const PlotArrangement &arrangement,
                const PlotTypography &typography, const SeriesColours &colours, std::optional<double> markedTime);

} // namespace slidercrank
