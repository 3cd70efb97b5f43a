// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/label_room.h"

#include "ui/mechanism/mechanism_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

/// Liang and Barsky: whether some of the line is within.
bool isWithin(const QRectF &box, const QLineF &line)
{
    double enter = 0.0;
    double leave = 1.0;
    const auto cut = [&](double from, double step, double lower, double upper) {
        if (step == 0.0) {
            return lower <= from && from <= upper;
        }
        const auto [first, last] = std::minmax({(lower - from) / step, (upper - from) / step});
        enter = std::max(enter, first);
        leave = std::min(leave, last);
        return enter <= leave;
    };
    return cut(line.x1(), line.dx(), box.left(), box.right()) && cut(line.y1(), line.dy(), box.top(), box.bottom());
}

} // namespace

void LabelRoom::keepOff(const QLineF &link, double width)
{
    m_links.push_back({link, 0.5 * width});
}

void LabelRoom::keepOff(const QRectF &box)
{
    m_boxes.push_back(box);
}

void LabelRoom::ratherKeepOff(const QLineF &line)
{
    m_lines.push_back(line);
}

double LabelRoom::crossedBy(const QRectF &label) const
{
    constexpr double kOutside = 8.0;
    constexpr double kOverLink = 4.0;
    constexpr double kOverBox = 6.0; // a label over another is not to be read
    constexpr double kOverLine = 1.0;
    double crossed = m_drawing.contains(label) ? 0.0 : kOutside;
    for (const Link &link : m_links) {
        const double half = link.halfWidth;
        crossed += isWithin(label.adjusted(-half, -half, half, half), link.line) ? kOverLink : 0.0;
    }
    for (const QRectF &box : m_boxes) {
        crossed += box.intersects(label) ? kOverBox : 0.0;
    }
    for (const QLineF &line : m_lines) {
        crossed += isWithin(label, line) ? kOverLine : 0.0;
    }
    return crossed;
}

QRectF LabelRoom::place(const QSizeF &label, const std::vector<QPointF> &centres)
{
    QRectF best;
    double least = 0.0;
    for (const QPointF &centre : centres) {
        const QRectF box(centre.x() - 0.5 * label.width(), centre.y() - 0.5 * label.height(), label.width(),
                         label.height());
        const double crossed = crossedBy(box);
        if (best.isNull() || crossed < least) {
            best = box;
            least = crossed;
        }
        if (least == 0.0) {
            break;
        }
    }
    m_boxes.push_back(best);
    return best;
}

std::vector<QPointF> placesAround(QPointF point, QPointF direction, double reach, const QSizeF &label)
{
    constexpr double kEighth = std::numbers::pi / 4.0;
    constexpr std::array kTurns{0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0};
    const QPointF ahead = unitVector(direction);
    std::vector<QPointF> places;
    for (const double away : {reach, reach + label.height(), reach + 2.0 * label.height()}) {
        for (const double turn : kTurns) {
            const double cosine = std::cos(turn * kEighth);
            const double sine = std::sin(turn * kEighth);
            const QPointF to(ahead.x() * cosine - ahead.y() * sine, ahead.x() * sine + ahead.y() * cosine);
            // All of the box beyond, in the direction that counts more.
            const double most = std::max(std::abs(to.x()), std::abs(to.y()));
            places.push_back(point + away * to +
                             QPointF(0.5 * label.width() * to.x(), 0.5 * label.height() * to.y()) / most);
        }
    }
    return places;
}

} // namespace slidercrank
