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

constexpr double kRadius = 3.5; // px, of a dot

} // namespace

PlotPane::PlotPane(const QPixmap &picture, QWidget *figure)
    : QWidget(figure)
    , m_picture(picture)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setFocusPolicy(Qt::TabFocus);
}

void PlotPane::setCursors(const std::vector<Cursor> &cursors, const QRect &axes)
{
    const QRect before = m_painted;
    m_axes = axes;
    m_cursors = cursors;
    m_labels.clear();
    QRectF painted;
    for (const Cursor &cursor : m_cursors) {
        addLabels(cursor);
        painted |= QRectF(cursor.x, m_axes.top(), 1.0, m_axes.height());
        for (const Line &line : cursor.lines) {
            painted |= line.dot ? QRectF(*line.dot, QSizeF(1.0, 1.0)) : QRectF();
        }
    }
    for (const Label &label : m_labels) {
        painted |= label.place;
    }
    constexpr int kAround = 5; // px, more than the radius of a dot
    m_painted = painted.toAlignedRect().adjusted(-kAround, -kAround, kAround, kAround);
    // One rectangle: where the region to paint has several, Qt starts threads to fill it, which costs far more.
    update(before | m_painted);
}

/// Places the labels to the right of the line, or to its left where they do not fit. Headings are at the top, values at
/// the height of their dots, moved only so far that they do not overlap.
void PlotPane::addLabels(Cursor cursor)
{
    constexpr double kGap = 6.0; // px, between the line and the text
    const QFontMetricsF metrics(font());
    const double height = metrics.height();
    std::ranges::stable_sort(cursor.lines, {}, [](const Line &line) { return line.dot ? line.dot->y() : 0.0; });
    double top = m_axes.top();
    double lowest = m_axes.bottom() - static_cast<double>(cursor.lines.size()) * height;
    for (const Line &line : cursor.lines) {
        const double width = metrics.horizontalAdvance(line.text);
        const bool fits = cursor.x + kGap + width <= m_axes.right();
        const double x = fits ? cursor.x + kGap : std::max(1.0, cursor.x - kGap - width);
        const double wanted = std::max(top, line.dot ? line.dot->y() - 0.5 * height : top);
        const double y = std::max(0.0, std::min(lowest, wanted));
        m_labels.push_back({QRectF(x, y, width, height), line.colour, line.text});
        top = y + height;
        lowest += height;
    }
}

QString PlotPane::text() const
{
    QStringList lines;
    for (const Label &label : m_labels) {
        lines << label.text;
    }
    return lines.join(u'\n');
}

void PlotPane::paintEvent(QPaintEvent *)
{
    const SeriesColours colours = seriesColours(palette());
    QPainter painter(this);
    painter.drawPixmap(-pos(), m_picture);
    for (const Cursor &cursor : m_cursors) {
        painter.setOpacity(cursor.isLight ? 0.45 : 1.0);
        painter.fillRect(QRect(static_cast<int>(cursor.x), m_axes.top(), 1, m_axes.height()), colours.cursor);
        painter.setOpacity(1.0);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(colours.background); // separates a dot from its curve
        for (const Line &line : cursor.lines) {
            if (line.dot) {
                painter.setBrush(line.colour);
                painter.drawEllipse(*line.dot, kRadius, kRadius);
            }
        }
        painter.setRenderHint(QPainter::Antialiasing, false);
    }
    QColor behind = colours.background;
    behind.setAlphaF(0.8F);
    for (const Label &label : m_labels) {
        painter.fillRect(label.place, behind);
        painter.setPen(label.colour);
        painter.drawText(label.place, Qt::AlignCenter | Qt::TextDontClip, label.text);
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

} // namespace slidercrank
