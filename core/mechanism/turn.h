// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One turn of the crank, and an angle's place within it (rad).

#include <cmath>
#include <numbers>

namespace slidercrank
{

inline constexpr double kTurn = 2.0 * std::numbers::pi;
inline constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

/// Into [-π, π).
inline double wrapToPi(double angle)
{
    const double turned = angle - kTurn * std::floor((angle + std::numbers::pi) / kTurn);
    return turned >= std::numbers::pi ? turned - kTurn : turned;
}

/// Into [0, 2π).
inline double wrapToTwoPi(double angle)
{
    const double turned = angle - kTurn * std::floor(angle / kTurn);
    return turned >= kTurn ? 0.0 : turned;
}

} // namespace slidercrank
