// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What one reads at the pointer and at the measuring cursors: numbers with names and units, in the inks of their
// curves.

#include "ui/plots/plot_figure.h"
#include "ui/plots/plot_overlay.h"

#include <QFont>

#include <array>
#include <optional>
#include <vector>

namespace slidercrank
{

struct ReadInstants {
    std::optional<std::size_t> hovered;            ///< the plot under the pointer
    double hoverTime = 0.0;                        ///< s, where it is
    std::optional<std::array<double, 2>> measured; ///< s, of the measuring cursors 1 and 2
};

/// How much room there is: fewer digits, without what can be read elsewhere.
enum class Wording { Full, Brief };

/// What the plot shows under the pointer, or else at the measuring cursors, a row each.
std::vector<InkedRow> readingsOf(PlotFigure &figure, std::size_t plot, const ReadInstants &read, Wording wording);

/// A place of a curve at which it is read; the ink tells which.
struct ReadPoint {
    CurvePoint point;
    Ink ink = Ink::Model;
};
std::vector<ReadPoint> pointsReadAt(PlotFigure &figure, std::size_t plot, double t);

/// Where the measuring cursors are, in as many words as that room (px) has; empty without them.
QString measuredText(const PlotFigure &figure, const ReadInstants &read, const QFont &font, int room);

} // namespace slidercrank
