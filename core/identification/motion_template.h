// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The textbook's motion on numbers that carry derivatives by the parameters.

#include "core/closed_form/textbook_motion.h"

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

namespace slidercrank
{

/// The derivatives by a, b, c, ω2 and θ2.
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 5, 1>>;

inline double plainValue(double x)
{
    return x;
}

inline double plainValue(const Dual &x)
{
    return x.value();
}

template <class T>
using MotionTemplate = TextbookMotion<T>;

} // namespace slidercrank
