// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where a box of readings stands beside the curves that it is about. All in px of the plot.

#include <QPointF>
#include <QPolygonF>
#include <QRect>
#include <QSizeF>

#include <vector>

namespace slidercrank
{

/// What a box should not hide.
struct PlotSight {
    QRect axes;                    ///< outside of them there are the numbers of the axes
    std::vector<QPolygonF> curves; ///< in parts without gaps
    std::vector<QPointF> dots;     ///< what is read; not to be hidden by any means
    std::vector<int> lines;        ///< upright ones at the instants that are read
};

struct ReadingPlace {
    QPointF topLeft;
    double hidden = 0.0; ///< how much of the curves and numbers, px; infinite where the room is too small
};

/// In the room, where it hides least, and of these places next to the dots; in its corner where that is too small.
ReadingPlace placeOfReading(const QSizeF &box, const QRect &room, const PlotSight &sight);

} // namespace slidercrank
