// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_drag.h"

#include "ui/mechanism/mechanism_canvas.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// The double nearest to the multiple: 3 · 0.1 is 0.3; and never -0.
double onGrid(double value, double grid)
{
    const double steps = std::round(value / grid) + 0.0;
    return grid < 1.0 ? steps / std::round(1.0 / grid) : steps * grid;
}

/// As drawn, y upwards.
QPointF direction(QPointF from, QPointF to)
{
    const QPointF along = to - from;
    return along.isNull() ? QPointF(1.0, 0.0) : unitVector(along);
}

/// For a pull along a line of that direction, y upwards.
Qt::CursorShape cursorAlong(QPointF pull)
{
    constexpr double kSlanted = 0.41; // tangent of 22.5°
    const double x = std::abs(pull.x());
    const double y = std::abs(pull.y());
    if (y <= kSlanted * x) {
        return Qt::SizeHorCursor;
    }
    if (x <= kSlanted * y) {
        return Qt::SizeVerCursor;
    }
    return pull.x() * pull.y() < 0.0 ? Qt::SizeFDiagCursor : Qt::SizeBDiagCursor;
}

} // namespace

std::optional<Parameter> lengthDraggedBy(DrawnPart part, bool withShift)
{
    switch (part) {
    case DrawnPart::A: return withShift ? std::optional(Parameter::A) : std::nullopt;
    case DrawnPart::B: return withShift ? std::optional(Parameter::B) : std::nullopt;
    case DrawnPart::Crank: return Parameter::A;
    case DrawnPart::Coupler: return Parameter::B;
    case DrawnPart::Guide: return Parameter::C;
    case DrawnPart::Background:
    case DrawnPart::O2:
    case DrawnPart::G3:
    case DrawnPart::OuterDeadCentre:
    case DrawnPart::InnerDeadCentre:
    case DrawnPart::ForbiddenArc: break;
    }
    return std::nullopt;
}

std::optional<Qt::CursorShape> cursorOver(const MechanismDrawing &drawing, DrawnPart part, bool withShift)
{
    if (!drawing.result) {
        return std::nullopt;
    }
    const bool pulls = lengthDraggedBy(part, withShift).has_value();
    if (pulls && part == DrawnPart::Guide) {
        return Qt::SizeVerCursor;
    }
    if (pulls && (part == DrawnPart::A || part == DrawnPart::Crank)) {
        return cursorAlong(drawing.crankPin());
    }
    if (pulls && drawing.pins) {
        return part == DrawnPart::B ? Qt::SizeHorCursor : cursorAlong(drawing.pins->B - drawing.pins->A);
    }
    if (part == DrawnPart::A || part == DrawnPart::B) {
        return drawing.mechanism().omega2() != 0.0 ? Qt::OpenHandCursor : Qt::ArrowCursor;
    }
    const bool isDeadCentre = part == DrawnPart::OuterDeadCentre || part == DrawnPart::InnerDeadCentre;
    return isDeadCentre ? std::optional(Qt::PointingHandCursor) : std::nullopt;
}

std::optional<MechanismDrag> MechanismDrag::begin(const MechanismDrawing &drawing, DrawnPart part, bool withShift,
                                                  QPointF at)
{
    if (!drawing.result) {
        return std::nullopt;
    }
    MechanismDrag drag;
    drag.m_part = part;
    drag.m_length = lengthDraggedBy(part, withShift);
    drag.m_mechanism = drawing.mechanism();
    drag.m_limits = drawing.result->limits;
    drag.m_start = at;
    drag.m_crankPin = drawing.crankPin();
    if (drag.m_length) {
        switch (part) {
        case DrawnPart::Guide: drag.m_along = {0.0, 1.0}; return drag;
        case DrawnPart::A:
        case DrawnPart::Crank: drag.m_along = direction({0.0, 0.0}, drag.m_crankPin); return drag;
        default: break;
        }
        if (!drawing.pins) {
            return std::nullopt;
        }
        drag.m_along = direction(drawing.pins->A, drawing.pins->B);
        drag.m_followsSlider = part == DrawnPart::B && drawing.pose.exists();
        drag.m_grip = at - drawing.pins->B;
        return drag;
    }
    const double omega2 = drag.m_mechanism.omega2();
    if (omega2 == 0.0 || !std::isfinite(drawing.pose.theta2)) {
        return std::nullopt;
    }
    if (part == DrawnPart::A) {
        drag.m_grip = at - drag.m_crankPin;
        return drag;
    }
    if (part == DrawnPart::B && drawing.pose.exists()) {
        const std::optional<SliderStroke> stroke =
            strokeAround(drag.m_mechanism, drag.m_limits, drawing.pose.theta2, omega2 > 0.0 ? 1 : -1);
        if (stroke) {
            drag.m_stroke = *stroke;
            drag.m_grip = at - drawing.pins->B;
            return drag;
        }
    }
    return std::nullopt;
}

double MechanismDrag::lengthBefore() const
{
    return m_length ? valueOf(m_mechanism.parameters(), *m_length) : 0.0;
}

DragRequest MechanismDrag::moveTo(QPointF pointer, double grid)
{
    if (m_length) {
        return lengthAt(pointer, grid);
    }
    return m_part == DrawnPart::A ? turnTo(pointer - m_grip) : slideTo(pointer.x() - m_grip.x());
}

DragRequest MechanismDrag::turnTo(QPointF pointer) const
{
    return pointer.isNull() ? DragRequest() : CrankAngleRequest{std::atan2(pointer.y(), pointer.x())};
}

DragRequest MechanismDrag::slideTo(double R4x)
{
    if (m_pushedAgainst != 0) {
        const double end = m_pushedAgainst > 0 ? m_stroke.to : m_stroke.from;
        const double R4xEnd = m_pushedAgainst > 0 ? m_stroke.R4xTo : m_stroke.R4xFrom;
        const double R4xOther = m_pushedAgainst > 0 ? m_stroke.R4xFrom : m_stroke.R4xTo;
        if ((R4x - R4xEnd) * (R4xOther - R4xEnd) <= 0.0) {
            return CrankAngleRequest{end}; // still pushed against it
        }
        if (const std::optional<SliderStroke> next = strokeAround(m_mechanism, m_limits, end, m_pushedAgainst)) {
            m_stroke = *next; // at the end of a rocker's arc there is none, and the slider goes back as it came
        }
    }
    const double theta2 = crankAngleAt(m_mechanism, m_stroke, R4x);
    m_pushedAgainst = theta2 == m_stroke.to ? 1 : theta2 == m_stroke.from ? -1 : 0;
    return CrankAngleRequest{theta2};
}

DragRequest MechanismDrag::lengthAt(QPointF pointer, double grid) const
{
    const bool mayBeNegative = *m_length == Parameter::C;
    double length = lengthBefore() + QPointF::dotProduct(pointer - m_start, m_along);
    if (m_followsSlider) {
        const double side = m_mechanism.branch() == Branch::Open ? 1.0 : -1.0;
        const double across = std::max(0.0, side * (pointer.x() - m_grip.x() - m_crankPin.x()));
        length = std::hypot(across, m_mechanism.c() - m_crankPin.y());
    }
    length = std::clamp(onGrid(length, grid), mayBeNegative ? -kLargestParameter : grid, kLargestParameter);
    return std::isfinite(length) ? DragRequest(LengthRequest{*m_length, length}) : DragRequest();
}

} // namespace slidercrank
