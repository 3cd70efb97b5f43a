// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The coupler's instant centre P: the point about which it turns at that instant, so that each of its points moves
// square to the ray from P, at |ω3| times its distance from P. A moves square to the crank and B along the slider's
// line; so P is where the crank's line meets the upright through B (Norton, "Design of Machinery", sections 6.3
// and 6.4):
//
//     P = (R4x, a sin θ2 + s tan θ2)      s = b cos θ3      PA = |s / cos θ2|      PB = |P_y - c|
//
// Where cos θ2 is 0, P is beyond all bounds: the coupler does not turn, and all of its points move alike. Lengths in
// mm, angles in rad, time in s.

#include "core/limits/linkage_point.h"

#include <optional>

namespace slidercrank
{

struct InstantCentre {
    PlaneVector position; ///< y may be infinite
    double omega3 = 0.0;  ///< NaN where velocities do not exist
    double toA = 0.0;
    double toB = 0.0;
};

/// None where there is no pose, and where crank and coupler both stand square to the slider's line.
std::optional<InstantCentre> instantCentre(const Mechanism &mechanism, double t);

} // namespace slidercrank
