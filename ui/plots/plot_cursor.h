// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A cursor marks a time at which the curves of a plot are read: it has a vertical line, a dot on each curve, and the
// values beside the line. PlotPane paints cursors on the screen, PlotFigure in exported pictures.

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
    /// The importance of a value, the most important first. Errors have the rank Model.
    enum class Rank { Model, File, Pinned };

    /// Text beside the line: a heading, or a value with a dot on its curve. Positions are in px.
    struct Label {
        QStaticText text;
        QColor colour;
        std::optional<QPointF> dot = {};          ///< a heading has none
        std::optional<QRectF> previousPlace = {}; ///< of the previous frame, relative to anchorOf()
        QRectF place = {};                        ///< px, where the text stands; placeLabels() chooses it
        Rank rank = Rank::Model;
        std::optional<double> crossing = {}; ///< y (px) at which the drawn curve crosses the line; nullopt in a gap
    };

    double x = 0.0;              ///< of the line, px
    bool followsPointer = false; ///< rather than the current time; the line is then pale
    std::vector<Label> labels = {};
    std::vector<QPointF> curvePoints = {}; ///< px, of the curves beside the line, which labels shall not cover
};

/// Returns the point of the line beside which a label is placed: where its curve crosses the line or, in a gap, at the
/// height of its dot.
QPointF anchorOf(const PlotCursor &cursor, const PlotCursor::Label &label);

/// Returns the cursor moved by an offset (px), such as from the figure into one of its panes.
PlotCursor translated(PlotCursor cursor, QPointF offset);

/// Return the distance from the line (px) up to which PlotCursor::curvePoints has points, and the spacing (px) of the
/// points, for text in the font.
double curveReach(const QFont &font);
double curveSpacing(const QFont &font);

/// Returns the radius (px) of a dot beside text in the font.
double dotRadius(const QFont &font);

/// Sets Label::previousPlace of the cursors that have moved a little, as from frame to frame of an animation, so that
/// their values do not jump from one side of the line to the other.
void setPreviousPlaces(std::vector<PlotCursor> &cursors, std::span<const PlotCursor> before);

/// The treatment of a value that would cover a curve in every place near its dot.
enum class CrowdedLabelPolicy {
    CoverLeast, ///< it is written where it covers the curves least
    LeaveOut    ///< it is not written, nor is any value of its rank or of a less important rank; their dots remain
};

/// Places the labels of the cursors of one plot so that they avoid its curves. The first cursor is that of the current
/// time: if a label of a later cursor covers one of its values, only the dot of this value remains.
void placeLabels(std::vector<PlotCursor> &cursors, const QRectF &axes, const QFont &font, CrowdedLabelPolicy policy);

/// Paints the cursors. Requires placeLabels() to have placed their labels.
void paintCursors(QPainter &painter, std::span<const PlotCursor> cursors, const QRectF &axes, const QFont &font,
                  const SeriesColours &colours);

} // namespace slidercrank
