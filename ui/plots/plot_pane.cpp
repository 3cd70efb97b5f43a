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
constexpr double kGap = 6.0;    // px, between a cursor and what is written beside it

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
    m_font = font;
    m_colours = colours;
    update();
}

void PlotPane::setCursors(const std::vector<Cursor> &cursors, const QRect &axes)
{
    QRegion changed = region();
    m_axes = axes;
    m_cursors = cursors;
    m_labels.clear();
    for (const Cursor &cursor : m_cursors) {
        m_labels.push_back(labels(cursor));
    }
    update(changed + region());
}

void PlotPane::setFrame(const QRect &frame)
{
    if (frame != m_frame) {
        m_frame = frame;
        update();
    }
}

/// Beside the line on the side with more room; values at the height of their dots, as far as they leave one another
/// room, below the heading.
std::vector<PlotPane::Label> PlotPane::labels(const Cursor &cursor) const
{
    const QFontMetricsF metrics(m_font);
    const double height = metrics.height();
    std::vector<Label> labels;
    double top = m_axes.top();
    const auto add = [&](const QString &text, const QColor &colour, double y) {
        const double width = metrics.horizontalAdvance(text);
        const bool fits = cursor.x + kGap + width <= m_axes.right();
        const double x = fits ? cursor.x + kGap : std::max(1.0, cursor.x - kGap - width);
        labels.push_back({QRectF(x, y, width, height), colour, text});
        top = y + height;
    };
    for (const QString &line : cursor.heading) {
        add(line, m_colours.text, top);
    }
    std::vector<Dot> dots = cursor.dots;
    std::ranges::stable_sort(dots, {}, [](const Dot &dot) { return dot.at.y(); });
    const std::size_t first = labels.size();
    for (const Dot &dot : dots) {
        add(dot.text, dot.colour, std::max(top, dot.at.y() - 0.5 * height));
    }
    double bottom = m_axes.bottom();
    for (std::size_t i = labels.size(); i-- > first;) { // up again, where they reach below the axes
        bottom = std::min(bottom, labels[i].place.bottom());
        labels[i].place.moveBottom(bottom);
        bottom -= height;
    }
    return labels;
}

QRegion PlotPane::region() const
{
    QRegion region;
    for (std::size_t i = 0; i < m_cursors.size(); ++i) {
        const int x = static_cast<int>(m_cursors[i].x);
        region += QRect(x - 1, m_axes.top(), 3, m_axes.height());
        for (const Dot &dot : m_cursors[i].dots) {
            region += QRectF(dot.at.x() - kRadius, dot.at.y() - kRadius, 2.0 * kRadius, 2.0 * kRadius)
                          .toAlignedRect()
                          .adjusted(-1, -1, 1, 1);
        }
        for (const Label &label : m_labels[i]) {
            region += label.place.toAlignedRect().adjusted(-1, -1, 1, 1);
        }
    }
    return region;
}

QString PlotPane::text() const
{
    QStringList lines;
    for (const std::vector<Label> &labels : m_labels) {
        for (const Label &label : labels) {
            lines << label.text;
        }
    }
    return lines.join(u'\n');
}

std::vector<QRectF> PlotPane::labelPlaces() const
{
    std::vector<QRectF> places;
    for (const std::vector<Label> &labels : m_labels) {
        for (const Label &label : labels) {
            places.push_back(label.place);
        }
    }
    return places;
}

void PlotPane::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    update();
}

void PlotPane::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    update();
}

void PlotPane::paintEvent(QPaintEvent *event)
{
    QPainter painter(this);
    const double ratio = m_picture.devicePixelRatio();
    for (const QRect &part : event->region()) {
        painter.drawPixmap(QRectF(part), m_picture,
                           QRectF(part.translated(pos()).topLeft() * ratio, part.size() * ratio));
    }
    painter.setFont(m_font);
    for (std::size_t i = 0; i < m_cursors.size(); ++i) {
        const Cursor &cursor = m_cursors[i];
        QColor line = m_colours.cursor;
        line.setAlphaF(cursor.isLight ? 0.45F : 1.0F);
        painter.fillRect(QRect(static_cast<int>(cursor.x), m_axes.top(), 1, m_axes.height()), line);
        painter.setRenderHint(QPainter::Antialiasing);
        for (const Dot &dot : cursor.dots) {
            painter.setPen(QPen(m_colours.background, 1.0)); // tells it from its curve
            painter.setBrush(dot.colour);
            painter.drawEllipse(dot.at, kRadius, kRadius);
        }
        painter.setRenderHint(QPainter::Antialiasing, false);
        QColor behind = m_colours.background;
        behind.setAlphaF(0.8F);
        for (const Label &label : m_labels[i]) {
            painter.fillRect(label.place, behind);
            painter.setPen(label.colour);
            painter.drawText(label.place, Qt::AlignCenter | Qt::TextDontClip, label.text);
        }
    }
    const QColor highlight = palette().color(QPalette::Highlight);
    painter.setBrush(Qt::NoBrush);
    if (!m_frame.isNull()) {
        QColor within = highlight;
        within.setAlphaF(0.15F);
        painter.setPen(QPen(highlight, 1));
        painter.setBrush(within);
        painter.drawRect(m_frame.adjusted(0, 0, -1, -1));
        painter.setBrush(Qt::NoBrush);
    }
    if (hasFocus()) {
        painter.setPen(QPen(highlight, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

} // namespace slidercrank
