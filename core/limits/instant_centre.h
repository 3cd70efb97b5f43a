// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the instant centre P of the coupler with respect to the ground: each point of the coupler moves
// perpendicular to the ray from P, at |ω3| times its distance from P. A moves perpendicular to the crank and B along
// the slider's line, so that P is the intersection of the crank's line with the line through B parallel to y (Norton,
// "Design of Machinery", sections 6.3 and 6.4):
//
//     P = (R4x, a sin θ2 + s tan θ2)      s = b cos θ3      PA = |s / cos θ2|      PB = |P_y - c|
//
// If cos θ2 = 0, P is at infinity: the coupler does not rotate, and all of its points have the same velocity. Lengths
// in mm, angles in rad, time in s.

#include "core/limits/linkage_point.h"

#include <optional>

namespace slidercrank
{

struct InstantCentre {
    PlaneVector position;     ///< y may be infinite
    double omega3 = 0.0;      ///< rad/s; NaN if velocities do not exist
    double distanceToA = 0.0; ///< mm
    double distanceToB = 0.0; ///< mm
};

/// Returns nullopt if the mechanism cannot be assembled at time t (s), or if crank and coupler are both perpendicular
/// to the slider's line.
std::optional<InstantCentre> instantCentre(const Mechanism &mechanism, double t);

} // namespace slidercrank
