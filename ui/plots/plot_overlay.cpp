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
    painter.setRenderHint(QPainter::Antialiasing);
    for (const OverlayContent::Dot &dot : m_content.dots) {
        constexpr double kRadius = 3.5;
        painter.setPen(QPen(m_colours.background, 1.0)); // to be told from its curve
        painter.setBrush(colourOf(dot.ink, m_colours));
        painter.drawEllipse(dot.at, kRadius, kRadius);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    const QColor highlight = palette().color(QPalette::Highlight);
    if (!m_content.frame.isNull()) {
        constexpr int kOpacity = 40; // of 255
        QColor within = highlight;
        within.setAlpha(kOpacity);
        painter.setPen(QPen(highlight, 1));
        painter.setBrush(within);
        painter.drawRect(m_content.frame.adjusted(0, 0, -1, -1));
    }
    if (!m_content.box.empty()) {
        paintBox(painter);
    }
    if (m_content.hasFocus) {
        painter.setPen(QPen(highlight, 2));
        painter.setBrush(Qt::NoBrush); // the box left its own
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

QSizeF PlotOverlay::sizeOf(const std::vector<InkedRow> &box) const
{
    const QFontMetricsF metrics(m_font);
    double width = 0.0;
    for (const InkedRow &row : box) {
        double length = 0.0;
        for (const InkedText &part : row) {
            length += metrics.horizontalAdvance(part.text);
        }
        width = std::max(width, length);
    }
    return {width + 2 * kPadding, metrics.height() * static_cast<double>(box.size()) + 2 * kPadding};
}

void PlotOverlay::paintBox(QPainter &painter) const
{
    const QFontMetricsF metrics(m_font);
    const double lineHeight = metrics.height();
    const QRectF box(m_content.boxPlace, sizeOf(m_content.box));
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
