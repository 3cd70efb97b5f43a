// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_drag.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

/// The double nearest to the multiple of the grid: 3 · 0.1 gives 0.3; never -0.
double roundedTo(double grid, double value)
{
    const double steps = std::round(value / grid) + 0.0;
    return grid < 1.0 ? steps / std::round(1.0 / grid) : steps * grid;
}

/// The direction (y upwards) in which pulling the part makes its length longer.
QPointF pullDirection(const MechanismScene &scene, DrawnPart part)
{
    const QPointF A = scene.crankPin();
    const QPointF along = part == DrawnPart::Guide     ? QPointF(0.0, 1.0)
                          : part == DrawnPart::Coupler ? scene.wristPin() - A
                                                       : A;
    return unitVector(along);
}

} // namespace

std::optional<Parameter> draggedLength(DrawnPart part, bool withShift)
{
    switch (part) {
    case DrawnPart::A: return withShift ? std::optional(Parameter::A) : std::nullopt;
    case DrawnPart::Crank: return Parameter::A;
    case DrawnPart::Coupler: return Parameter::B;
    case DrawnPart::Guide: return Parameter::C;
    default: return std::nullopt;
    }
}

std::optional<Qt::CursorShape> cursorOver(const MechanismScene &scene, DrawnPart part, bool withShift)
{
    if (draggedLength(part, withShift)) {
        constexpr std::array kShapes{Qt::SizeHorCursor, Qt::SizeBDiagCursor, Qt::SizeVerCursor, Qt::SizeFDiagCursor};
        const QPointF along = pullDirection(scene, part);
        const long eighths = std::lround(4.0 * std::atan2(along.y(), along.x()) / std::numbers::pi);
        return kShapes[static_cast<std::size_t>((eighths + 4) % 4)];
    }
    switch (part) {
    case DrawnPart::A:
    case DrawnPart::B:
    case DrawnPart::Slider: return scene.mechanism().omega2() != 0.0 ? Qt::OpenHandCursor : Qt::ArrowCursor;
    case DrawnPart::OuterDeadCentre:
    case DrawnPart::InnerDeadCentre: return Qt::PointingHandCursor;
    default: return std::nullopt;
    }
}

std::optional<MechanismDrag> MechanismDrag::begin(const MechanismScene &scene, DrawnPart part, bool withShift,
                                                  QPointF pointer)
{
    MechanismDrag drag;
    drag.m_length = draggedLength(part, withShift);
    drag.m_mechanism = scene.mechanism();
    drag.m_limits = scene.result->limits;
    drag.m_start = pointer;
    if (drag.m_length) {
        drag.m_direction = pullDirection(scene, part);
        return drag;
    }
    const double omega2 = drag.m_mechanism.omega2();
    if (omega2 == 0.0 || !std::isfinite(scene.pose.theta2)) {
        return std::nullopt;
    }
    if (part == DrawnPart::A) {
        drag.m_grip = pointer - scene.crankPin();
        return drag;
    }
    if ((part == DrawnPart::B || part == DrawnPart::Slider) && scene.pose.exists()) {
        drag.m_grip = pointer - scene.wristPin();
        drag.m_stroke = strokeAround(drag.m_mechanism, drag.m_limits, scene.pose.theta2, omega2 > 0.0 ? 1 : -1);
    }
    return drag.m_stroke ? std::optional(drag) : std::nullopt;
}

double MechanismDrag::lengthBefore() const
{
    return valueOf(m_mechanism.parameters(), *m_length);
}

double MechanismDrag::lengthAt(QPointF pointer, double grid) const
{
    const double length = lengthBefore() + QPointF::dotProduct(pointer - m_start, m_direction);
    const double smallest = *m_length == Parameter::C ? -kLargestParameter : grid;
    return std::clamp(roundedTo(grid, length), smallest, kLargestParameter);
}

double MechanismDrag::crankAngleAt(QPointF pointer)
{
    const QPointF point = pointer - m_grip;
    return m_stroke ? crankAngleOfSlider(point.x()) : std::atan2(point.y(), point.x());
}

double MechanismDrag::crankAngleOfSlider(double R4x)
{
    if (m_pushedAgainst != 0) {
        const bool isAtEnd = m_pushedAgainst > 0;
        const double end = isAtEnd ? m_stroke->to : m_stroke->from;
        const double R4xHere = isAtEnd ? m_stroke->R4xTo : m_stroke->R4xFrom;
        const double R4xThere = isAtEnd ? m_stroke->R4xFrom : m_stroke->R4xTo;
        if ((R4x - R4xHere) * (R4xThere - R4xHere) <= 0.0) {
            return end; // still pushed against it
        }
        // Where an oscillating crank turns back there is no next stroke: the slider goes back the way it came.
        if (const std::optional<SliderStroke> next = strokeAround(m_mechanism, m_limits, end, m_pushedAgainst)) {
            m_stroke = next;
        }
    }
    const double theta2 = slidercrank::crankAngleAt(m_mechanism, *m_stroke, R4x);
    m_pushedAgainst = theta2 == m_stroke->to ? 1 : theta2 == m_stroke->from ? -1 : 0;
    return theta2;
}

} // namespace slidercrank
