// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_pane.h"

#include <QFontMetricsF>
#include <QPaintEvent>
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

void PlotPane::setStyle(const QFont &font, const SeriesColours &colours)
{
    setFont(font);
    m_colours = colours;
    update();
}

void PlotPane::setCursors(const std::vector<Cursor> &cursors, const QRect &axes)
{
    const QRect before = m_painted;
    m_axes = axes;
    m_cursors = cursors;
    m_labels.clear();
    m_painted = QRect();
    const auto add = [this](const QRectF &part) { m_painted |= part.toAlignedRect().adjusted(-1, -1, 1, 1); };
    for (const Cursor &cursor : m_cursors) {
        addLabels(cursor);
        add(QRectF(cursor.x, m_axes.top(), 1.0, m_axes.height()));
        for (const Dot &dot : cursor.dots) {
            add(QRectF(dot.place, QSizeF()).adjusted(-kRadius, -kRadius, kRadius, kRadius));
        }
    }
    for (const Label &label : m_labels) {
        add(label.place);
    }
    // One rectangle: where the region to paint has several, Qt starts threads to fill it, which costs far more.
    update(before | m_painted);
}

void PlotPane::setFrame(const QRect &frame)
{
    if (frame != m_frame) {
        m_frame = frame;
        update();
    }
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
        add(line, m_colours.text, top);
    }
    std::vector<Dot> dots = cursor.dots;
    std::ranges::stable_sort(dots, {}, [](const Dot &dot) { return dot.place.y(); });
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const double lowest = m_axes.bottom() - static_cast<double>(dots.size() - i) * metrics.height();
        add(dots[i].text, dots[i].colour, std::min(lowest, std::max(top, dots[i].place.y() - 0.5 * metrics.height())));
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

void PlotPane::paintEvent(QPaintEvent *event)
{
    QPainter painter(this);
    const double ratio = m_picture.devicePixelRatio();
    const QRectF part = event->rect();
    painter.drawPixmap(part, m_picture, QRectF(part.translated(pos()).topLeft() * ratio, part.size() * ratio));
    for (const Cursor &cursor : m_cursors) {
        QColor line = m_colours.cursor;
        line.setAlphaF(cursor.isLight ? 0.45F : 1.0F);
        painter.fillRect(QRect(static_cast<int>(cursor.x), m_axes.top(), 1, m_axes.height()), line);
        painter.setRenderHint(QPainter::Antialiasing);
        for (const Dot &dot : cursor.dots) {
            painter.setPen(QPen(m_colours.background, 1.0)); // separates the dot from its curve
            painter.setBrush(dot.colour);
            painter.drawEllipse(dot.place, kRadius, kRadius);
        }
        painter.setRenderHint(QPainter::Antialiasing, false);
    }
    QColor behind = m_colours.background;
    behind.setAlphaF(0.8F);
    for (const Label &label : m_labels) {
        painter.fillRect(label.place, behind);
        painter.setPen(label.colour);
        painter.drawText(label.place, Qt::AlignCenter | Qt::TextDontClip, label.text);
    }
    QColor highlight = palette().color(QPalette::Highlight);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(highlight, 2));
    if (hasFocus()) {
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    if (!m_frame.isNull()) {
        painter.setPen(highlight);
        highlight.setAlphaF(0.15F);
        painter.setBrush(highlight);
        painter.drawRect(m_frame.adjusted(0, 0, -1, -1));
    }
}

} // namespace slidercrank
