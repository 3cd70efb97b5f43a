// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_canvas.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

MechanismCanvas canvasOf(const MechanismProjection &projection, const QPalette &palette, const QFont &font)
{
    MechanismCanvas canvas;
    static_cast<MechanismProjection &>(canvas) = projection;
    canvas.colours = seriesColours(palette);
    canvas.muted = mixed(canvas.colours.text, canvas.colours.background, 0.6);
    canvas.highlight = palette.color(QPalette::Highlight);
    canvas.font = font;
    canvas.font.setPixelSize(QFontInfo(font).pixelSize());
    canvas.smallFont = canvas.font;
    canvas.smallFont.setPixelSize(std::max(9, canvas.font.pixelSize() - 2));
    return canvas;
}

QColor mixed(const QColor &colour, const QColor &background, double share)
{
    const auto blend = [share](int x, int y) { return static_cast<int>(std::lround(share * x + (1.0 - share) * y)); };
    return QColor(blend(colour.red(), background.red()), blend(colour.green(), background.green()),
                  blend(colour.blue(), background.blue()));
}

QPointF unitVector(QPointF vector)
{
    const double length = std::hypot(vector.x(), vector.y());
    return length > 0.0 ? vector / length : QPointF(0.0, -1.0);
}

void paintJoint(QPainter &painter, QPointF at, const QColor &edge, const QColor &fill)
{
    painter.setPen(QPen(edge, 1.6));
    painter.setBrush(fill);
    painter.drawEllipse(at, kJointRadius, kJointRadius);
}

void paintArrowHead(QPainter &painter, QPointF tip, QPointF direction, double length, const QColor &colour)
{
    const QPointF back = tip - length * direction;
    const QPointF across = 0.36 * length * QPointF(-direction.y(), direction.x());
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF{tip, back + across, back - across});
}

QRectF cornerLine(const MechanismCanvas &on, int line, double width)
{
    constexpr double kLeft = 3.0; // over the numbers of the grid, not beside them
    constexpr double kTop = 6.0;
    const double height = QFontMetricsF(on.smallFont).height() + 2.0;
    return QRectF(kLeft, kTop + line * height, width, height);
}

void paintNote(QPainter &painter, const MechanismCanvas &on, QPointF centre, const QString &text)
{
    const QFontMetricsF metrics(on.font);
    QRectF box(0.0, 0.0, metrics.horizontalAdvance(text) + 4.0, metrics.height());
    box.moveCenter(centre);
    QColor paper = on.colours.background;
    paper.setAlphaF(0.85F);
    painter.fillRect(box, paper);
    painter.setFont(on.font);
    painter.setPen(on.colours.text);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace slidercrank
