// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_cursor.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace slidercrank
{

namespace
{

enum class Side { Right, Left };

/// Returns the left end of a label on that side of the line, or on the other side where it does not fit. A label that
/// fits on neither side begins at the left edge of the axes, beside their numbers.
double labelLeft(double line, double width, const QRectF &axes, Side side)
{
    constexpr double kGap = 6.0; // px, between the line and the text
    const double right = line + kGap;
    const double left = line - kGap - width;
    const bool fitsRight = right + width <= axes.right();
    const bool fitsLeft = left > axes.left();
    if (fitsRight && (side == Side::Right || !fitsLeft)) {
        return right;
    }
    return std::max(axes.left() + 1.0, left);
}

/// Returns the places of the labels, which are in the order of their heights. Headings are at the top, values `shift`
/// (px) below the height of their dots, moved only so far that they do not overlap.
std::vector<QRectF> labelPlaces(const PlotCursor &cursor, const QRectF &axes, double height, Side side, double shift)
{
    const double total = static_cast<double>(cursor.labels.size()) * height;
    // The next label may begin between these two: below the labels before it, with space for those after it.
    double highest = std::max(0.0, std::min(axes.top(), axes.bottom() - total));
    double lowest = std::max(highest, axes.bottom() - total);
    std::vector<QRectF> places;
    for (const PlotCursor::Label &label : cursor.labels) {
        const double width = label.text.size().width();
        const double wanted = std::max(highest, label.dot ? label.dot->y() - 0.5 * height + shift : highest);
        const QRectF place(labelLeft(cursor.x, width, axes, side), std::min(lowest, wanted), width, height);
        places.push_back(place);
        highest = place.bottom();
        lowest += height;
    }
    return places;
}

/// Returns how many points of the curves are below values. Headings stand at the top in any case.
std::ptrdiff_t coveredPoints(const PlotCursor &cursor, const std::vector<QRectF> &places)
{
    std::ptrdiff_t covered = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (cursor.labels[i].dot) {
            covered += std::ranges::count_if(cursor.curves,
                                             [&place = places[i]](QPointF point) { return place.contains(point); });
        }
    }
    return covered;
}

/// Places the labels where they cover the fewest points of the curves: if possible to the right of the line, at the
/// height of their dots.
void placeLabelsOf(PlotCursor &cursor, const QRectF &axes, const QFont &font)
{
    constexpr std::array kShifts{0.0, -0.5, 0.5, -1.0, 1.0, -1.5, 1.5}; // heights of a label
    const double height = QFontMetricsF(font).height();
    std::ranges::stable_sort(cursor.labels, {},
                             [](const PlotCursor::Label &label) { return label.dot ? label.dot->y() : 0.0; });
    for (PlotCursor::Label &label : cursor.labels) {
        label.text.prepare({}, font);
    }
    std::ptrdiff_t fewest = std::numeric_limits<std::ptrdiff_t>::max();
    for (const Side side : {Side::Right, Side::Left}) {
        for (const double shift : kShifts) {
            const std::vector<QRectF> places = labelPlaces(cursor, axes, height, side, shift * height);
            const std::ptrdiff_t covered = coveredPoints(cursor, places);
            if (covered >= fewest) {
                continue;
            }
            fewest = covered;
            for (std::size_t i = 0; i < places.size(); ++i) {
                cursor.labels[i].place = places[i];
            }
            if (covered == 0) {
                return;
            }
        }
    }
}

} // namespace

double curveReach(const QFont &font)
{
    constexpr double kWidestValue = 5.0; // heights of its text, with the gap beside the line
    return kWidestValue * QFontMetricsF(font).height();
}

double curveSpacing(const QFont &font)
{
    constexpr double kPointsPerLine = 7.0; // so that a curve cannot cross a label unnoticed
    return QFontMetricsF(font).height() / kPointsPerLine;
}

double dotRadius(const QFont &font)
{
    return std::max(3.5, 0.27 * font.pixelSize());
}

void placeLabels(std::vector<PlotCursor> &cursors, const QRectF &axes, const QFont &font)
{
    for (PlotCursor &cursor : cursors) {
        placeLabelsOf(cursor, axes, font);
        for (PlotCursor::Label &covered : cursors.front().labels) {
            const auto covers = [&](const PlotCursor::Label &label) { return label.place.intersects(covered.place); };
            if (&cursor != &cursors.front() && std::ranges::any_of(cursor.labels, covers)) {
                covered.text.setText({});
                covered.place = QRectF();
            }
        }
    }
}

void paintCursors(QPainter &painter, std::span<const PlotCursor> cursors, const QRectF &axes, const QFont &font,
                  const SeriesColours &colours)
{
    const double radius = dotRadius(font);
    painter.setFont(font);
    for (const PlotCursor &cursor : cursors) {
        painter.setOpacity(cursor.isLight ? 0.45 : 1.0);
        painter.setPen(QPen(colours.cursor, 1.0, Qt::SolidLine, Qt::FlatCap)); // a rectangle may vanish in a preview
        painter.drawLine(QLineF(cursor.x + 0.5, axes.top(), cursor.x + 0.5, axes.bottom()));
        painter.setOpacity(1.0);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(colours.background); // separates a dot from its curve
        for (const PlotCursor::Label &label : cursor.labels) {
            if (label.dot) {
                painter.setBrush(label.colour);
                painter.drawEllipse(*label.dot, radius, radius);
            }
        }
        painter.setRenderHint(QPainter::Antialiasing, false);
    }
    QColor behind = colours.background;
    behind.setAlphaF(0.8F);
    for (const PlotCursor &cursor : cursors) {
        for (const PlotCursor::Label &label : cursor.labels) {
            painter.fillRect(label.place, behind);
            painter.setPen(label.colour);
            painter.drawStaticText(label.place.topLeft(), label.text);
        }
    }
}

} // namespace slidercrank
