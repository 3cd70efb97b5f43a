// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The data that a drawing of the mechanism shows, and the scale of the velocity and acceleration arrows at A, B and G3.
// The scale is the same for the whole motion, so that arrows can be compared, and it is a round number: "10 mm = 50
// mm/s". Arrows much longer than that of A (as at the limit of an oscillating crank) are shortened and dashed.

#include "core/comparison/reference_pose.h"
#include "core/limits/linkage_point.h"
#include "ui/document/result.h"
#include "ui/document/view_settings.h"

#include <QRectF>

#include <memory>

namespace slidercrank
{

/// The scale of the arrows of the velocities or of the accelerations.
struct ArrowScale {
    PlaneVector PointMotion::*vector; ///< the vector that an arrow represents
    double length = 0.0;              ///< mm of the model, a round number
    double amount = 0.0;  ///< speed (mm/s) or acceleration (mm/s²) of an arrow of this length; 0 if nothing moves
    double largest = 0.0; ///< arrows of larger amounts are shortened, mm/s or mm/s²

    bool isOfVelocity() const { return vector == &PointMotion::velocity; }
};

struct MechanismScene {
    std::shared_ptr<const Result> result; ///< null if nothing is to be drawn
    Pose pose;
    ReferencePose ghost;      ///< the linkage of the reference or of the pinned motion
    ReferencePose markedPose; ///< the linkage in a position that a table refers to
    MechanismSettings settings;
    QRectF button; ///< px: the area of the button for the assembly; empty in pictures

    const Mechanism &mechanism() const { return result->mechanism; }

    /// Returns A, mm. It exists at every crank angle, even if the mechanism cannot be assembled.
    QPointF crankPin() const { return mechanism().a() * QPointF(pose.motion.crank.cos, pose.motion.crank.sin); }

    /// Returns B, mm. Requires pose.exists().
    QPointF wristPin() const { return {pose.motion.R4x, mechanism().c()}; }

    double alpha2() const { return result->choices.alpha2; } ///< rad/s²: acceleration of the crank

    /// Returns the motion of a point at the time of the pose, with the acceleration alpha2() of the crank.
    PointMotion motion(LinkagePoint point) const;

    /// Returns a box of that size in the corner of the area that is away from the crank and the slider's line. Where
    /// `obstacle` is in that corner, the box is above or below it.
    QRectF inFreeCorner(const QRectF &area, const QSizeF &size, const QRectF &obstacle = {}) const;

    /// Returns the scale of the velocities or of the accelerations.
    ArrowScale arrows(PlaneVector PointMotion::*vector) const;
};

} // namespace slidercrank
