// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The textbook's motion, evaluated with or without derivatives with respect to the parameters.

#include "core/closed_form/textbook_motion.h"

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

namespace slidercrank
{

/// A number with its derivatives with respect to a, b, c, ω2 and θ2.
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
