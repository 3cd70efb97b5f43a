// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Wraps angles to one revolution (rad).

#include <cmath>
#include <numbers>

namespace slidercrank
{

inline constexpr double kTurn = 2.0 * std::numbers::pi;
inline constexpr double kHalfTurn = std::numbers::pi;
inline constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

/// Wraps an angle to [-π, π).
inline double wrapToPi(double angle)
{
    const double wrapped = angle - kTurn * std::floor((angle + std::numbers::pi) / kTurn);
    const bool isBeyond = wrapped < -std::numbers::pi || wrapped >= std::numbers::pi; // by a rounding error
    return isBeyond ? -std::numbers::pi : wrapped;
}

/// Wraps an angle to [0, 2π).
inline double wrapToTwoPi(double angle)
{
    const double wrapped = angle - kTurn * std::floor(angle / kTurn);
    const bool isBeyond = wrapped < 0.0 || wrapped >= kTurn; // by a rounding error
    return isBeyond ? 0.0 : wrapped;
}

} // namespace slidercrank
