// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_cursor.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace slidercrank
{

namespace
{

/// Places the labels to the right of the line, or to its left where they do not fit; a label that fits on neither side
/// begins at the left edge of the axes, beside their numbers. Headings are at the top, values at the height of their
/// dots, moved only so far that they do not overlap.
void placeLabelsOf(PlotCursor &cursor, const QRectF &axes, const QFont &font)
{
    constexpr double kGap = 6.0; // px, between the line and the text
    const double height = QFontMetricsF(font).height();
    std::ranges::stable_sort(cursor.labels, {},
                             [](const PlotCursor::Label &label) { return label.dot ? label.dot->y() : 0.0; });
    const double total = static_cast<double>(cursor.labels.size()) * height;
    // The next label may begin between these two: below the labels before it, with space for those after it.
    double highest = std::max(0.0, std::min(axes.top(), axes.bottom() - total));
    double lowest = std::max(highest, axes.bottom() - total);
    for (PlotCursor::Label &label : cursor.labels) {
        label.text.prepare({}, font);
        const double width = label.text.size().width();
        const bool fits = cursor.x + kGap + width <= axes.right();
        const double x = fits ? cursor.x + kGap : std::max(axes.left() + 1.0, cursor.x - kGap - width);
        const double wanted = std::max(highest, label.dot ? label.dot->y() - 0.5 * height : highest);
        label.place = QRectF(x, std::min(lowest, wanted), width, height);
        highest = label.place.bottom();
        lowest += height;
    }
}

} // namespace

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
