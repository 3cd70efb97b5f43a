// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A time at which the curves of a plot are read: a vertical line, a dot on each curve, and the values beside the line.
// The panes draw it on the screen, the figure in exported pictures.

#include "ui/text/theme.h"

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QStaticText>

#include <optional>
#include <span>
#include <vector>

class QPainter;

namespace slidercrank
{

struct PlotCursor {
    /// The importance of a value, the most important first. Errors have that of the model.
    enum class Rank { Model, File, Pinned };

    /// Text beside the line: a heading, or a value with a dot on its curve. Positions are in px.
    struct Label {
        QStaticText text;
        QColor colour;
        std::optional<QPointF> dot = {};      ///< a heading has none
        std::optional<QRectF> lastPlace = {}; ///< the last place, from anchorOf()
        QRectF place = {};                    ///< px, where the text stands; placeLabels() chooses it
        Rank rank = Rank::Model;
        std::optional<double> crossing = {}; ///< px, where the curve crosses the line, if the dot is beside the line
    };

    double x = 0.0;       ///< px
    bool isLight = false; ///< follows the pointer
    std::vector<Label> labels = {};
    std::vector<QPointF> curves = {}; ///< points (px) of the curves beside the line, which the labels shall not cover
};

/// Returns the point of the line beside which the value of a label stands: where the curve crosses the line.
QPointF anchorOf(const PlotCursor &cursor, const PlotCursor::Label &label);

/// Returns the cursor moved by an offset (px), such as from the figure into one of its panes.
PlotCursor translated(PlotCursor cursor, QPointF offset);

/// Return the distance from the line (px) up to which PlotCursor::curves has points, and the spacing (px) of the
/// points, for text in the font.
double curveReach(const QFont &font);
double curveSpacing(const QFont &font);

/// Returns the radius (px) of a dot beside text in the font.
double dotRadius(const QFont &font);

/// Sets Label::lastPlace of the cursors that have moved by at most kMaxMoveOfFrame, as from frame to frame of an
/// animation, so that their values do not jump from one side of the line to the other.
void keepPlaces(std::vector<PlotCursor> &cursors, std::span<const PlotCursor> before);

/// The treatment of a value that would cover a curve in every place near its dot.
enum class CrowdedLabelPolicy {
    CoverLeast, ///< it is written where it covers the curves least
    LeaveOut    ///< it is not written, nor is any value of its rank or of a less important rank; their dots remain
};

/// Places the labels of the cursors of one plot with these axes beside the curves. If a label of a later cursor covers
/// a value of the first cursor, that of the current time, only the dot of the covered value remains.
void placeLabels(std::vector<PlotCursor> &cursors, const QRectF &axes, const QFont &font, CrowdedLabelPolicy policy);

/// Paints the cursors, whose labels have been placed.
void paintCursors(QPainter &painter, std::span<const PlotCursor> cursors, const QRectF &axes, const QFont &font,
                  const SeriesColours &colours);

} // namespace slidercrank
