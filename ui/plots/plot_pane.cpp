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
        for (const Dot &dot : cursor.dots) {
            painted |= QRectF(dot.place, QSizeF(1.0, 1.0));
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

/// Places the labels to the right of the line, or to its left where they do not fit. Values are at the height of their
/// dots, moved only so far that they do not overlap each other and the heading.
void PlotPane::addLabels(const Cursor &cursor)
{
    constexpr double kGap = 6.0; // px, between the line and the text
    const QFontMetricsF metrics(font());
    double top = m_axes.top();
    const auto add = [&](const QString &text, const QColor &colour, double y) {
        const double width = metrics.horizontalAdvance(text);
        const bool fits = cursor.x + kGap + width <= m_axes.right();
        const double x = fits ? cursor.x + kGap : std::max(1.0, cursor.x - kGap - width);
        m_labels.push_back({QRectF(x, y, width, metrics.height()), colour, text});
        top = m_labels.back().place.bottom();
    };
    for (const QString &line : cursor.heading) {
        add(line, seriesColours(palette()).text, top);
    }
    std::vector<Dot> dots = cursor.dots;
    std::ranges::stable_sort(dots, {}, [](const Dot &dot) { return dot.place.y(); });
    double lowest = m_axes.bottom() - static_cast<double>(dots.size()) * metrics.height();
    for (const Dot &dot : dots) {
        add(dot.text, dot.colour, std::min(lowest, std::max(top, dot.place.y() - 0.5 * metrics.height())));
        lowest += metrics.height();
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
        for (const Dot &dot : cursor.dots) {
            painter.setBrush(dot.colour);
            painter.drawEllipse(dot.place, kRadius, kRadius);
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
