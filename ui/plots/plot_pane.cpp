// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_pane.h"

#include "ui/text/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace slidercrank
{

namespace
{

/// The radius (px) of a dot beside text of that font.
double dotRadius(const QFont &font)
{
    return std::max(3.5, 0.27 * font.pixelSize());
}

} // namespace

PlotPane::PlotPane(const QPixmap &picture, QWidget *figure)
    : QWidget(figure)
    , m_picture(picture)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::TabFocus);
}

void PlotPane::setCursors(std::vector<Cursor> cursors, const QRect &axes)
{
    const QRect before = m_painted;
    m_axes = axes;
    m_cursors = std::move(cursors);
    QRectF painted;
    for (Cursor &cursor : m_cursors) {
        placeLabels(cursor);
        for (Label &covered : m_cursors.front().labels) {
            const auto covers = [&](const Label &label) { return label.place.intersects(covered.place); };
            if (&cursor != &m_cursors.front() && std::ranges::any_of(cursor.labels, covers)) {
                covered.text.setText({}); // only the dot remains
                covered.place = QRectF();
            }
        }
        painted |= QRectF(cursor.x, m_axes.top(), 1.0, m_axes.height());
        for (const Label &label : cursor.labels) {
            painted |= label.place;
        }
    }
    const double around = dotRadius(font()) + 1.5; // px, for the dots on the line
    m_painted = painted.adjusted(-around, -around, around, around).toAlignedRect();
    // One rectangle: where the region to paint has several, Qt starts threads to fill it, which costs far more.
    update(before | m_painted);
}

/// Places the labels to the right of the line, or to its left where they do not fit. Headings are at the top, values at
/// the height of their dots, moved only so far that they do not overlap.
void PlotPane::placeLabels(Cursor &cursor) const
{
    constexpr double kGap = 6.0; // px, between the line and the text
    const double height = QFontMetricsF(font()).height();
    std::ranges::stable_sort(cursor.labels, {}, [](const Label &label) { return label.dot ? label.dot->y() : 0.0; });
    double top = m_axes.top();
    double lowest = m_axes.bottom() - static_cast<double>(cursor.labels.size()) * height;
    for (Label &label : cursor.labels) {
        label.text.prepare({}, font());
        const double width = label.text.size().width();
        const bool fits = cursor.x + kGap + width <= m_axes.right();
        const double x = fits ? cursor.x + kGap : std::max(1.0, cursor.x - kGap - width);
        const double wanted = std::max(top, label.dot ? label.dot->y() - 0.5 * height : top);
        const double y = std::max(0.0, std::min(lowest, wanted));
        label.place = QRectF(x, y, width, height);
        top = y + height;
        lowest += height;
    }
}

void PlotPane::paintEvent(QPaintEvent *)
{
    const SeriesColours colours = seriesColours(palette());
    const double radius = dotRadius(font());
    QPainter painter(this);
    painter.drawPixmap(-pos(), m_picture);
    for (const Cursor &cursor : m_cursors) {
        painter.setOpacity(cursor.isLight ? 0.45 : 1.0);
        painter.fillRect(QRect(static_cast<int>(cursor.x), m_axes.top(), 1, m_axes.height()), colours.cursor);
        painter.setOpacity(1.0);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(colours.background); // separates a dot from its curve
        for (const Label &label : cursor.labels) {
            if (label.dot) {
                painter.setBrush(label.colour);
                painter.drawEllipse(*label.dot, radius, radius);
            }
        }
        painter.setRenderHint(QPainter::Antialiasing, false);
    }
    QColor behind = colours.background;
    behind.setAlphaF(0.8F);
    for (const Cursor &cursor : m_cursors) {
        for (const Label &label : cursor.labels) {
            painter.fillRect(label.place, behind);
            painter.setPen(label.colour);
            painter.drawStaticText(label.place.topLeft(), label.text);
        }
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

} // namespace slidercrank

#include "moc_plot_pane.cpp"
