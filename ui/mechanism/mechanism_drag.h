// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Converts positions of the pointer to crank angles or lengths while a part of the mechanism is dragged. The point at
// which the part was grasped stays under the pointer. Lengths and points are in mm, angles in rad.

#include "core/limits/mobility.h"
#include "ui/mechanism/mechanism_drawing.h"
#include "ui/mechanism/mechanism_scene.h"

#include <optional>

namespace slidercrank
{

/// Returns the length that dragging the part changes, or nullopt.
std::optional<Parameter> draggedLength(DrawnPart part, bool withShift);

/// Returns the shape of the pointer over the part.
Qt::CursorShape cursorOver(const MechanismScene &scene, DrawnPart part, bool withShift);

class MechanismDrag
{
public:
    /// Begins a drag at the point `pointer`. Returns nullopt if the part cannot be dragged.
    static std::optional<MechanismDrag> begin(const MechanismScene &scene, DrawnPart part, bool withShift,
                                              QPointF pointer);

    /// Returns the length that changes, or nullopt if the drag moves the crank.
    std::optional<Parameter> length() const { return m_length; }
    double lengthBefore() const; ///< at the beginning of the drag

    /// Returns the length for a position of the pointer, rounded to a multiple of `grid` (a round number, mm). Requires
    /// length().
    double lengthAt(QPointF pointer, double grid) const;

    /// Returns the crank angle for a position of the pointer, up to whole turns. Requires !length().
    double crankAngleAt(QPointF pointer);

private:
    MechanismDrag() = default;
    double crankAngleOfSlider(double R4x);

    std::optional<Parameter> m_length;
    Mechanism m_mechanism; ///< at the beginning of the drag
    MotionLimits m_limits;
    QPointF m_start;     ///< the position of the pointer at the beginning
    QPointF m_direction; ///< unit vector; dragging in this direction increases the length

    // A drag of the slider. Between two dead centres the position of the slider determines the crank angle. When the
    // slider has reached a dead centre and comes back, the crank continues beyond the dead centre, as with a flywheel.
    std::optional<SliderStroke> m_stroke;
    std::optional<CrankDirection> m_endReached; ///< counter-clockwise: the stroke's `to`; clockwise: its `from`
    QPointF m_grip;                             ///< vector from A or B to the pointer
};

} // namespace slidercrank
