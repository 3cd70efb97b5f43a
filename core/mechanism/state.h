// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All 12 coordinates at one instant, as vectors. Apart from mechanism.h because most of the program reads that one, and
// not Eigen.

#include "core/mechanism/mechanism.h"

#include <Eigen/Core>

namespace slidercrank
{

using Vector12 = Eigen::Matrix<double, kCoordinateCount, 1>;
using Matrix12 = Eigen::Matrix<double, kCoordinateCount, kCoordinateCount>;

/// One instant: coordinates and their first and second time derivatives (mm, rad, s); NaN where they do not exist.
struct State {
    Vector12 q;
    Vector12 qDot;
    Vector12 qDDot;
    Status status = Status::Solved;
};

} // namespace slidercrank
