// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the points move that one looks at in a linkage: the crank pin A, the slider's pin B, the coupler's centre of mass
// G3. Lengths in mm, time in s.

#include "core/limits/mobility.h"
#include "core/mechanism/mechanism.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace slidercrank
{

enum class LinkagePoint { A, B, G3 };
inline constexpr std::array<LinkagePoint, 3> kLinkagePoints{LinkagePoint::A, LinkagePoint::B, LinkagePoint::G3};

/// NaN where it does not exist.
struct PointMotion {
    Eigen::Vector2d position;
    Eigen::Vector2d velocity;
    Eigen::Vector2d acceleration;
};

PointMotion motionOf(LinkagePoint point, const State &state);

/// The exact state with the crank at that angle (rad), turning at its speed.
State stateAtCrankAngle(const Mechanism &mechanism, double theta2);

/// Crank angles from one end of the range to the other, closer together towards the ends, where a rocker's coupler
/// swings fastest.
std::vector<double> anglesAcross(const CrankRange &range, int steps);

} // namespace slidercrank
