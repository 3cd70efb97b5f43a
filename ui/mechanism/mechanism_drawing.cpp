// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_drawing.h"

#include "ui/text/subscripts.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slidercrank
{

static constexpr double kMutedInk = 0.6; // share of the ink in the colour of what is less important

MechanismDrawing::MechanismDrawing(const MechanismProjection &projection, const QPalette &palette, const QFont &font)
    : m_colours(seriesColours(palette))
    , m_ink(m_colours.text)
    , m_paper(m_colours.background)
    , m_muted(faded(m_ink, kMutedInk))
    , m_font(font)
    , m_smallFont(font)
    , m_projection(projection)
{
    constexpr int kSmallestReadable = 9; // px
    constexpr int kSmaller = 2;          // px
    const int pixels = QFontInfo(font).pixelSize();
    m_font.setPixelSize(pixels);
    m_smallFont.setPixelSize(std::max(kSmallestReadable, pixels - kSmaller));
}

void MechanismDrawing::paint(QPainter &painter) const
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_colours.grid);
    painter.drawRects(m_grid);
    painter.setRenderHint(QPainter::Antialiasing); // not of the grid, whose lines are whole pixels
    // Invisible shapes are left out, because some programs show a transparent shape of an SVG file in black.
    for (const DrawnShape &shape : m_shapes) {
        const bool isFilled = shape.brush != Qt::NoBrush && shape.brush.color().alpha() > 0;
        if (isFilled || shape.pen.style() != Qt::NoPen) {
            painter.setPen(shape.pen);
            painter.setBrush(shape.brush);
            painter.drawPath(shape.path);
        }
    }
    for (const Label &label : m_labels) {
        if (label.paper.alpha() > 0) {
            painter.fillRect(label.box, label.paper);
        }
        painter.setPen(label.ink);
        const QFont &font = label.isSmall ? m_smallFont : m_font;
        painter.setFont(font);
        if (label.text.contains(u'_')) {
            painter.drawStaticText(label.box.topLeft(), withSubscripts(label.text, font));
        } else {
            painter.drawText(label.box, label.alignment, label.text);
        }
    }
}

void MechanismDrawing::paintHighlight(QPainter &painter, DrawnPart part, const QColor &colour) const
{
    constexpr double kBeyondOutline = 5.0; // px, both sides together
    constexpr double kHighlightOpacity = 0.45;
    for (const DrawnShape &shape : m_shapes) {
        if (part != Background && shape.part == part && shape.pen.style() != Qt::NoPen) {
            painter.strokePath(shape.path, QPen(withAlpha(colour, kHighlightOpacity),
                                                shape.pen.widthF() + kBeyondOutline, Qt::SolidLine, Qt::RoundCap));
        }
    }
}

DrawnPart MechanismDrawing::partAt(QPointF pixel) const
{
    constexpr double kReach = 3.5; // px around a shape
    const auto isUnderPointer = [pixel](const DrawnShape &shape) {
        QPainterPathStroker stroker;
        stroker.setWidth(shape.pen.widthF() + 2.0 * kReach);
        return shape.part != Background && (stroker.createStroke(shape.path).contains(pixel) ||
                                            (shape.brush != Qt::NoBrush && shape.path.contains(pixel)));
    };
    const auto shape = std::find_if(m_shapes.rbegin(), m_shapes.rend(), isUnderPointer);
    return shape == m_shapes.rend() ? Background : shape->part;
}

bool MechanismDrawing::has(DrawnPart part) const
{
    return std::ranges::find(m_shapes, part, &DrawnShape::part) != m_shapes.end();
}

void MechanismDrawing::add(const QPainterPath &path, const QPen &pen, const QBrush &brush, DrawnPart part)
{
    m_shapes.push_back({.part = part, .path = path, .pen = pen, .brush = brush});
}

void MechanismDrawing::addLine(QPointF from, QPointF to, const QPen &pen, DrawnPart part)
{
    QPainterPath path(from);
    path.lineTo(to);
    add(path, pen, Qt::NoBrush, part);
}

void MechanismDrawing::addCircle(QPointF centre, double radius, const QPen &pen, const QBrush &brush, DrawnPart part)
{
    QPainterPath path;
    path.addEllipse(centre, radius, radius);
    add(path, pen, brush, part);
}

void MechanismDrawing::addArrowHead(QPointF tip, QPointF direction, double length, const QColor &colour)
{
    const QPointF back = tip - length * direction;
    constexpr double kHalfWidth = 0.36; // of the length
    const QPointF across = kHalfWidth * length * QPointF(-direction.y(), direction.x());
    QPainterPath path;
    path.addPolygon(QPolygonF{tip, back + across, back - across, tip});
    add(path, Qt::NoPen, colour);
}

void MechanismDrawing::addDimension(QPointF from, QPointF to, const QColor &colour)
{
    const QPointF direction = unitVector(to - from);
    constexpr double kHead = 8.0;         // px
    constexpr double kLargestShare = 0.4; // of the dimension, so that two heads do not meet
    const double head = std::min(kHead, kLargestShare * QLineF(from, to).length());
    addLine(from, to, QPen(colour, kHairline));
    addArrowHead(to, direction, head, colour);
    addArrowHead(from, -direction, head, colour);
}

QSizeF MechanismDrawing::textSize(const QString &text, TextSize letters) const
{
    const QFontMetricsF metrics(letters == TextSize::Small ? m_smallFont : m_font);
    constexpr double kSpaceBeside = 4.0; // px, both sides together
    return {metrics.horizontalAdvance(text) + kSpaceBeside, metrics.height()};
}

void MechanismDrawing::addLabelBeside(QPointF point, QPointF direction, double gap, const QString &text,
                                      const QColor &ink, TextSize letters)
{
    constexpr int kDirections = 8;
    constexpr int kDistances = 3;
    constexpr double kCostOutside = 10.0; // a label that is not within the drawing costs as much as ten overlaps
    constexpr double kEighth = std::numbers::pi / 4.0;
    const double ahead = std::atan2(direction.y(), direction.x());
    const QRectF inside(QPointF(), projection().size);
    QRectF box(QPointF(), textSize(text, letters));
    constexpr double kBelowLetters = 2.0; // px: a line of text is higher than its letters
    box.adjust(0.0, kBelowLetters, 0.0, -kBelowLetters);
    QRectF best;
    double lowestCost = std::numeric_limits<double>::infinity();
    for (int attempt = 0; attempt < kDirections * kDistances && lowestCost > 0.0; ++attempt) {
        const int turn = (attempt % kDirections + 1) / 2 * (attempt % 2 == 0 ? -1 : 1); // 0, 1, -1, 2, -2 …
        const int distance = attempt / kDirections;                                     // in heights of the label
        const QPointF away(std::cos(ahead + turn * kEighth), std::sin(ahead + turn * kEighth));
        // The label touches the gap with the side that faces the point.
        const double larger = std::max(std::abs(away.x()), std::abs(away.y()));
        box.moveCenter(point + (gap + distance * box.height()) * away +
                       QPointF(0.5 * box.width() * away.x(), 0.5 * box.height() * away.y()) / larger);
        const auto overlaps =
            std::ranges::count_if(m_occupied, [&](const QRectF &other) { return other.intersects(box); });
        const double cost = static_cast<double>(overlaps) + (inside.contains(box) ? 0.0 : kCostOutside);
        if (cost < lowestCost) {
            lowestCost = cost;
            best = box;
        }
    }
    avoid(best);
    constexpr double kOpacity = 0.6;
    m_labels.push_back({.text = text,
                        .box = best.adjusted(0.0, -kBelowLetters, 0.0, kBelowLetters),
                        .ink = ink,
                        .paper = withAlpha(m_paper, kOpacity),
                        .isSmall = letters == TextSize::Small});
}

void MechanismDrawing::addCornerLabel(int line, double indent, const QString &text)
{
    constexpr double kLeft = 3.0; // px
    const QRectF box(QPointF(kLeft + indent, cornerLineTop(line)), textSize(text, TextSize::Small));
    m_labels.push_back({.text = text, .box = box, .ink = m_ink, .paper = m_paper, .isSmall = true});
}

double MechanismDrawing::cornerLineTop(int line) const
{
    constexpr double kTop = 6.0;         // px
    constexpr double kLineSpacing = 2.0; // px
    return kTop + line * (textSize({}, TextSize::Small).height() + kLineSpacing);
}

void MechanismDrawing::avoid(const QLineF &line, double width)
{
    constexpr double kMinPiece = 3.0;     // px
    constexpr double kMaxPieces = 1000.0; // since an arrow can be much longer than the screen
    const int pieces = 1 + static_cast<int>(std::min(kMaxPieces, line.length() / std::max(kMinPiece, width)));
    for (int i = 0; i <= pieces; ++i) {
        QRectF box(0.0, 0.0, width, width);
        box.moveCenter(line.pointAt(static_cast<double>(i) / pieces));
        avoid(box);
    }
}

void MechanismDrawing::avoidAround(QPointF centre, double radius)
{
    avoid(QRectF(centre - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius)));
}

QColor withAlpha(QColor colour, double alpha)
{
    colour.setAlphaF(static_cast<float>(alpha));
    return colour;
}

QPointF unitVector(QPointF vector)
{
    const double length = std::hypot(vector.x(), vector.y());
    return length > 0.0 ? vector / length : QPointF(0.0, -1.0);
}

} // namespace slidercrank
