// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The data that a drawing of the mechanism shows, and the scale of the velocity and acceleration arrows at A, B and G3.
// The scale is the same for the whole motion, so that arrows can be compared, and it is a round number: "10 mm =
// 50 mm/s". Arrows of unbounded velocities and accelerations (at the limit of an oscillating crank) are shortened and
// dashed.

#include "core/comparison/reference_pose.h"
#include "core/limits/linkage_point.h"
#include "ui/document/result.h"
#include "ui/document/view_settings.h"

#include <QPointF>
#include <QString>

#include <memory>
#include <vector>

namespace slidercrank
{

enum class MotionKind { Velocity, Acceleration };

/// The motion over one revolution, or over each range of an oscillating crank.
using Cycle = std::vector<std::vector<LinkageMotion>>;

Cycle computeCycle(const Mechanism &mechanism, const MotionLimits &limits);

struct ArrowScale {
    double length = 0.0;  ///< mm of the drawing
    double amount = 0.0;  ///< the mm/s or mm/s² that this length represents; 0 if nothing moves
    double largest = 0.0; ///< arrows of larger amounts are shortened, mm/s or mm/s²
};

/// Returns a round scale with which no arrow of the cycle is longer than `longest` (mm).
ArrowScale computeArrowScale(const Cycle &cycle, MotionKind kind, const Mechanism &mechanism, double longest);

/// Returns "Scale: 10 mm = 50 mm/s".
QString arrowScaleText(const ArrowScale &scale, MotionKind kind);

/// Returns the vector that the arrow represents.
const PlaneVector &arrowVector(const PointMotion &motion, MotionKind kind);

struct MechanismScene {
    std::shared_ptr<const Result> result; ///< null if nothing is to be drawn
    Pose pose;
    ReferencePose ghost; ///< the linkage of the reference or of the pinned motion
    MechanismSettings settings;

    // These are empty unless arrows or the path of G3 are shown.
    Cycle cycle;
    ArrowScale velocity;
    ArrowScale acceleration;

    const Mechanism &mechanism() const { return result->mechanism; }

    /// Returns A, mm. It exists at every crank angle, even if the mechanism cannot be assembled.
    QPointF crankPin() const;

    /// Returns B, mm. Requires pose.exists().
    QPointF wristPin() const { return {pose.sliderX, mechanism().c()}; }

    PointMotion motion(LinkagePoint point) const;

    /// Updates the cycle and the scales. Call it when the mechanism or the settings change.
    void updateCycle();
};

} // namespace slidercrank
