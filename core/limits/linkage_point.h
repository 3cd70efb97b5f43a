// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the points move that one looks at in a linkage: the crank pin A, the slider's pin B, the coupler's centre of mass
// G3. Lengths in mm, time in s.

#include "core/mechanism/mechanism.h"

#include <array>
#include <cmath>

namespace slidercrank
{

enum class LinkagePoint { A, B, G3 };
inline constexpr std::array<LinkagePoint, 3> kLinkagePoints{LinkagePoint::A, LinkagePoint::B, LinkagePoint::G3};

struct PlaneVector {
    double x = 0.0;
    double y = 0.0;

    double length() const { return std::sqrt(x * x + y * y); }
    friend PlaneVector operator*(const PlaneVector &vector, double factor)
    {
        return {vector.x * factor, vector.y * factor};
    }
};

/// NaN where it does not exist.
struct PointMotion {
    PlaneVector position;
    PlaneVector velocity;
    PlaneVector acceleration;
};

/// By kLinkagePoints.
using LinkageMotion = std::array<PointMotion, kLinkagePoints.size()>;

/// Exact, at time t (s).
LinkageMotion linkageMotion(const Mechanism &mechanism, double t);

} // namespace slidercrank
