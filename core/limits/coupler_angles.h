// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the extremes of the coupler's angles over the motion: the transmission angle and θ3, and the angle by which
// the coupler swings. Lengths in mm, angles in rad.
//
// Source: R. L. Norton, "Design of Machinery", sections 3.3 and 4.10 (transmission angle).

#include "core/closed_form/motion_constants.h"

#include <vector>

namespace slidercrank
{

/// The smallest or largest value of an angle, and the crank angles at which it occurs, within [-π, π).
struct AngleExtreme {
    double angle = 0.0;
    std::vector<double> crankAngles = {};
};

struct CouplerAngles {
    /// The transmission angle is the acute angle between the coupler and the normal to the slider's line, π/2 - |θ3| on
    /// the open branch. Its minimum is 0 where the coupler becomes perpendicular to the slider's line.
    AngleExtreme minimumTransmissionAngle;
    AngleExtreme maximumTransmissionAngle;

    AngleExtreme minimumTheta3;
    AngleExtreme maximumTheta3;
    double swing = 0.0; ///< maximum minus minimum θ3
};

/// An end of an arc within which the crank of a rocker oscillates. There the coupler is perpendicular to the slider's
/// line.
struct ArcEnd {
    double theta2 = 0.0;         ///< within [-π, π)
    bool isBOnOffsetSide = true; ///< B is above A for c >= 0, or below A for c < 0
};

/// Requires that the mechanism can be assembled. `ends`: the ends of all arcs; empty if the crank makes full turns.
CouplerAngles couplerAngles(const MotionConstants &constants, const std::vector<ArcEnd> &ends);

} // namespace slidercrank
