// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A part of the mechanism while it is dragged: converts positions of the pointer to crank angles or lengths. The part
// stays under the pointer as it was grasped. Lengths and points in mm, angles in rad.

#include "core/limits/slider_stroke.h"
#include "ui/mechanism/mechanism_drawing.h"
#include "ui/mechanism/mechanism_scene.h"

#include <optional>

namespace slidercrank
{

/// The length that dragging the part changes.
std::optional<Parameter> draggedLength(DrawnPart part, bool withShift);

/// The pointer's shape over the part.
Qt::CursorShape cursorOver(const MechanismScene &scene, DrawnPart part, bool withShift);

class MechanismDrag
{
public:
    /// Nullopt if the part cannot be dragged. `pointer`: where it is grasped.
    static std::optional<MechanismDrag> begin(const MechanismScene &scene, DrawnPart part, bool withShift,
                                              QPointF pointer);

    /// The length that changes; nullopt: the crank moves.
    std::optional<Parameter> length() const { return m_length; }
    double lengthBefore() const; ///< when it was grasped

    /// The length for that position of the pointer, a multiple of `grid` (a round number). Requires length().
    double lengthAt(QPointF pointer, double grid) const;

    /// The crank angle for that position, whole turns apart. Requires !length().
    double crankAngleAt(QPointF pointer);

private:
    MechanismDrag() = default;
    double crankAngleOfSlider(double R4x);

    std::optional<Parameter> m_length;
    Mechanism m_mechanism; ///< when it was grasped
    MotionLimits m_limits;
    QPointF m_start;     ///< where it was grasped
    QPointF m_direction; ///< pulling this way makes the length longer; of length 1

    // Of the slider. Between two dead centres the crank angle follows from the slider's position. Pushed against a dead
    // centre, the crank goes on through it when the slider comes back, as with a flywheel.
    std::optional<SliderStroke> m_stroke;
    int m_pushedAgainst = 0; ///< the end of the stroke: +1 `to`, -1 `from`, 0 none
    QPointF m_grip;          ///< from the part's point to where it was grasped
};

} // namespace slidercrank
