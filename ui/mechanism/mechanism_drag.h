// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A part of the mechanism in somebody's hand: from where the pointer goes, to what that asks for. The part stays under
// the pointer as it was taken hold of.

#include "core/limits/slider_stroke.h"
#include "ui/mechanism/mechanism_drawing.h"

#include <optional>
#include <variant>

namespace slidercrank
{

/// The crank is to stand there, rad, whole turns apart.
struct CrankAngleRequest {
    double theta2 = 0.0;
};

/// A length is to be that, mm.
struct LengthRequest {
    Parameter parameter = Parameter::A;
    double length = 0.0;
};

using DragRequest = std::variant<std::monostate, CrankAngleRequest, LengthRequest>;

/// The length that a drag of the part changes; with Shift, that of the joints A and B too.
std::optional<Parameter> lengthDraggedBy(DrawnPart part, bool withShift);

/// What a pointer over the part looks like; none: as usual.
std::optional<Qt::CursorShape> cursorOver(const MechanismDrawing &drawing, DrawnPart part, bool withShift);

class MechanismDrag
{
public:
    /// Taken hold of at that point (mm). None where the part cannot be dragged.
    static std::optional<MechanismDrag> begin(const MechanismDrawing &drawing, DrawnPart part, bool withShift,
                                              QPointF at);

    DrawnPart part() const { return m_part; }

    /// Whether it edits, and does not only move the mechanism.
    std::optional<Parameter> length() const { return m_length; }
    double lengthBefore() const; ///< mm, when it was taken hold of

    /// What the pointer asks for there (mm); lengths come in multiples of `grid` (mm, a round number).
    DragRequest moveTo(QPointF pointer, double grid);

private:
    MechanismDrag() = default;
    DragRequest turnTo(QPointF pointer) const;
    DragRequest slideTo(double R4x);
    DragRequest lengthAt(QPointF pointer, double grid) const;

    DrawnPart m_part = DrawnPart::Background;
    std::optional<Parameter> m_length;
    Mechanism m_mechanism; ///< as it was taken hold of
    MotionLimits m_limits;
    QPointF m_start;              ///< where the pointer was
    QPointF m_grip;               ///< of it, from the part's point
    QPointF m_along;              ///< where to a pull makes the length longer, of length 1
    QPointF m_crankPin;           ///< A
    bool m_followsSlider = false; ///< b such that B is under the pointer

    // Of B: between two dead centres the crank follows the slider; pushed against one, the crank goes on through it
    // when the slider comes back, as a flywheel would.
    SliderStroke m_stroke;
    int m_pushedAgainst = 0; ///< the end of the stroke: +1 its `to`, -1 its `from`, 0 none
};

} // namespace slidercrank
