// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_drag.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Returns the nearest multiple of the grid as the nearest double: 0.3, not 3 · 0.1. Never returns -0.
double roundedTo(double grid, double value)
{
    const double steps = std::round(value / grid) + 0.0;
    return grid < 1.0 ? steps / std::round(1.0 / grid) : steps * grid;
}

} // namespace

std::optional<Parameter> draggedLength(DrawnPart part, bool withShift)
{
    using enum DrawnPart;
    switch (part) {
    case Crank: return Parameter::A;
    case A: return withShift ? std::optional(Parameter::A) : std::nullopt;
    case G3:
    case Coupler: return Parameter::B;
    case Guide: return Parameter::C;
    case Background:
    case Ground:
    case Slider:
    case O2:
    case B:
    case OuterDeadCentre:
    case InnerDeadCentre:
    case ForbiddenArc: break;
    }
    return std::nullopt;
}

Qt::CursorShape cursorOver(const MechanismScene &scene, DrawnPart part, bool withShift)
{
    using enum DrawnPart;
    if (draggedLength(part, withShift)) {
        return part == Guide ? Qt::SizeVerCursor : Qt::SizeAllCursor;
    }
    switch (part) {
    case A:
    case B:
    case Slider: return scene.mechanism().omega2() != 0.0 ? Qt::OpenHandCursor : Qt::ArrowCursor;
    case OuterDeadCentre:
    case InnerDeadCentre: return Qt::PointingHandCursor;
    case Background:
    case Ground:
    case Crank:
    case Coupler:
    case O2:
    case Guide:
    case G3:
    case ForbiddenArc: break;
    }
    return Qt::ArrowCursor;
}

std::optional<MechanismDrag> MechanismDrag::begin(const MechanismScene &scene, DrawnPart part, bool withShift,
                                                  QPointF pointer)
{
    MechanismDrag drag;
    drag.m_length = draggedLength(part, withShift);
    drag.m_mechanism = scene.mechanism();
    drag.m_limits = scene.result->limits;
    drag.m_start = pointer;
    if (drag.m_length == Parameter::A) {
        drag.m_direction = unitVector(scene.crankPin());
    } else if (drag.m_length == Parameter::B) {
        drag.m_direction = unitVector(scene.wristPin() - scene.crankPin());
    } else if (drag.m_length == Parameter::C) {
        drag.m_direction = {0.0, 1.0}; // y upwards
    }
    if (drag.m_length) {
        return drag;
    }
    const double omega2 = drag.m_mechanism.omega2();
    if (omega2 == 0.0 || !std::isfinite(scene.pose.motion.theta2)) {
        return std::nullopt;
    }
    if (part == DrawnPart::A) {
        drag.m_grip = pointer - scene.crankPin();
        return drag;
    }
    if ((part == DrawnPart::B || part == DrawnPart::Slider) && scene.pose.exists()) {
        drag.m_grip = pointer - scene.wristPin();
        drag.m_stroke = strokeAround(drag.m_limits, scene.pose.motion.theta2,
                                     omega2 > 0.0 ? CrankDirection::CounterClockwise : CrankDirection::Clockwise);
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
    if (m_endReached) {
        const bool isAtEnd = *m_endReached == CrankDirection::CounterClockwise;
        const SliderPosition end = isAtEnd ? m_stroke->to : m_stroke->from;
        const SliderPosition start = isAtEnd ? m_stroke->from : m_stroke->to;
        if ((R4x - end.R4x) * (start.R4x - end.R4x) <= 0.0) {
            return end.theta2; // the pointer is still beyond the end
        }
        // Where an oscillating crank reverses there is no next stroke; the slider returns on the same one.
        if (const std::optional<SliderStroke> next = strokeAround(m_limits, end.theta2, *m_endReached)) {
            m_stroke = next;
        }
    }
    const double theta2 = slidercrank::crankAngleAt(m_mechanism, *m_stroke, R4x);
    m_endReached.reset();
    if (theta2 == m_stroke->to.theta2) {
        m_endReached = CrankDirection::CounterClockwise;
    } else if (theta2 == m_stroke->from.theta2) {
        m_endReached = CrankDirection::Clockwise;
    }
    return theta2;
}

} // namespace slidercrank
