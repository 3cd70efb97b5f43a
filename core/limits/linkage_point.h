// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the motion of three points of the linkage: the crank pin A, the wrist pin B, and the coupler's centre of
// mass G3. Lengths in mm, time in s.

#include "core/mechanism/enum_table.h"
#include "core/mechanism/mechanism.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace slidercrank
{

enum class LinkagePoint { A, B, G3 };
inline constexpr std::array<LinkagePoint, enumeratorCount<LinkagePoint::G3>()> kLinkagePoints{
    LinkagePoint::A, LinkagePoint::B, LinkagePoint::G3};

struct PlaneVector {
    double x = 0.0;
    double y = 0.0;

    double length() const { return std::sqrt(x * x + y * y); }
};

/// Position, velocity and acceleration of a point (mm, s); NaN if they do not exist.
struct PointMotion {
    PlaneVector position;
    PlaneVector velocity;
    PlaneVector acceleration;
};

/// The motion of each point, in the order of kLinkagePoints.
using LinkageMotion = std::array<PointMotion, kLinkagePoints.size()>;

inline const PointMotion &motionOf(const LinkageMotion &motion, LinkagePoint point)
{
    return motion[static_cast<std::size_t>(point)];
}

/// Returns the exact motion of the points at time t (s), at which the crank has the acceleration alpha2 (rad/s²).
LinkageMotion linkageMotion(const Mechanism &mechanism, double t, double alpha2 = 0.0);

} // namespace slidercrank
