// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_overlay.h"

#include "ui/plots/plot_arrangement.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace slidercrank
{

namespace
{

constexpr int kPadding = 4; // px
constexpr int kInset = 3;   // px

double boxWidth(const std::vector<InkedRow> &box, const QFontMetricsF &metrics)
{
    double width = 0.0;
    for (const InkedRow &row : box) {
        double length = 0.0;
        for (const InkedText &part : row) {
            length += metrics.horizontalAdvance(part.text);
        }
        width = std::max(width, length);
    }
    return width + 2 * kPadding;
}

} // namespace

PlotOverlay::PlotOverlay(QWidget *plot)
    : QWidget(plot)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void PlotOverlay::setStyle(const QFont &font, const SeriesColours &colours)
{
    m_font = font;
    m_colours = colours;
    update();
}

void PlotOverlay::setContent(const OverlayContent &content)
{
    m_content = content;
    setVisible(!content.isEmpty());
    if (isVisibleTo(parentWidget())) {
        setGeometry(parentWidget()->rect());
        raise();
        update();
    }
}

QString PlotOverlay::text() const
{
    QString text;
    for (const InkedRow &row : m_content.box) {
        for (const InkedText &part : row) {
            text += part.text;
        }
        text += u'\n';
    }
    return text.trimmed();
}

void PlotOverlay::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setFont(m_font);
    const QRect &axes = m_content.axes;
    for (const OverlayContent::Line &line : m_content.lines) {
        painter.setPen(QPen(m_colours.text, 1, line.isSolid ? Qt::SolidLine : Qt::DotLine));
        painter.drawLine(line.x, axes.top(), line.x, axes.bottom());
        if (!line.name.isEmpty()) {
            constexpr int kGap = 3;
            painter.drawText(line.x + kGap, axes.bottom() - kGap, line.name);
        }
    }
    if (!m_content.box.empty()) {
        paintBox(painter);
    }
    if (m_content.hasFocus) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush); // the box left its own
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

bool PlotOverlay::fits(const std::vector<InkedRow> &box) const
{
    return boxWidth(box, QFontMetricsF(m_font)) <= parentWidget()->width() - 2 * kInset;
}

/// At the top, on the side where the last line is not; over the margins where the axes are too narrow.
void PlotOverlay::paintBox(QPainter &painter) const
{
    const QFontMetricsF metrics(m_font);
    const double lineHeight = metrics.height();
    QRectF box(0.0, 0.0, boxWidth(m_content.box, metrics),
               lineHeight * static_cast<double>(m_content.box.size()) + 2 * kPadding);
    const QRect &axes = m_content.axes;
    const bool toTheRight = !m_content.lines.empty() && m_content.lines.back().x < axes.center().x();
    box.moveTopLeft(
        QPointF(toTheRight ? axes.right() - kInset - box.width() : axes.left() + kInset, axes.top() + kInset));
    box.moveLeft(std::max(1.0, std::min(box.left(), width() - kInset - box.width())));
    constexpr int kOpacity = 225; // of 255
    QColor background = m_colours.background;
    background.setAlpha(kOpacity);
    painter.setPen(m_colours.grid);
    painter.setBrush(background);
    painter.drawRect(box);
    double y = box.top() + kPadding + metrics.ascent();
    for (const InkedRow &row : m_content.box) {
        double x = box.left() + kPadding;
        for (const InkedText &part : row) {
            painter.setPen(colourOf(part.ink, m_colours));
            painter.drawText(QPointF(x, y), part.text);
            x += metrics.horizontalAdvance(part.text);
        }
        y += lineHeight;
    }
}

} // namespace slidercrank
