// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the nine plots, their margins and their legend are in a figure of any size, on the screen and on paper, and how
// lines and lettering look.

#include "ui/plots/plot_figure.h"
#include "ui/text/theme.h"

#include <QFont>
#include <QMargins>
#include <QPen>
#include <QRect>

#include <array>
#include <optional>
#include <vector>

class QPainter;

namespace slidercrank
{

inline constexpr int kTickLength = 3; // px
inline constexpr int kLabelGap = 4;   // px between tick and label

/// Everything is sized in pixels, not points, so that it comes out right on every device.
struct PlotTypography {
    explicit PlotTypography(const QFont &base);

    int legendHeight() const;

    /// Around the axes of a plot whose longest label of the value axis has that many characters. Labels of the usual
    /// length all get the same room, so that nothing moves while the numbers change. So do those of a right axis.
    QMargins margins(int labelLength, bool hasTimeLabels, std::optional<int> rightLabelLength = std::nullopt) const;

    QFont title;
    QFont tick;
    int titleHeight = 0;
    int tickHeight = 0;
    double digitWidth = 0.0; ///< of the tick font
    double lineFactor = 1.0; ///< beside large letters lines are wider
};

/// Where legend and plots are in a figure of that size: all nine, those of the model with all the room where there are
/// no errors to show, or one alone; the cells of the others are empty.
struct PlotArrangement {
    PlotArrangement(const QSize &figure, const PlotTypography &typography, bool hasErrors,
                    std::optional<std::size_t> onlyPlot = std::nullopt);

    bool hasTimeLabels(std::size_t plot) const;

    QSize size;
    std::optional<std::size_t> only; ///< the plot that is alone
    QRect legend;
    std::array<QRect, kPlotCount> cells;
    bool hasTimeLabelsEverywhere = true; ///< else in the bottom row only
};

QColor colourOf(Ink ink, const SeriesColours &colours);
QPen penOf(Ink ink, const SeriesColours &colours, double lineFactor);

/// The same, faint, for what lies under curves.
QColor bandColourOf(Ink ink, const SeriesColours &colours);

inline constexpr double kDotSize = 4.0; // px, of a sample

/// The sign for a percentage that does not exist: a triangle pointing up to its tip.
void drawMark(QPainter &painter, const QPointF &tip, const QColor &colour);

/// One line. Where that is too short a name that may be elided gives way, then the length of the samples, then what may
/// be left out.
void drawLegend(QPainter &painter, const QRect &rect, const std::vector<LegendEntry> &entries,
                const PlotTypography &typography, const SeriesColours &colours);

} // namespace slidercrank
