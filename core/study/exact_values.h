// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the exact motion, with which the study compares its methods.

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/mechanism/two_part_angle.h"

#include <array>

namespace slidercrank
{

inline constexpr double kUnitRoundoff = 0.5 * kEpsilon; // 2^-53

/// Values below this fraction of naturalSize() are zero except for the rounding of the exact motion.
inline constexpr double kExactZero = 1e-36;

/// The exact motion at one time stamp, in the order of kPlottedChannels (mm, rad, s). The values are in two parts, so
/// that comparing with them takes no many-digit arithmetic.
struct ExactValues {
    Status status = Status::Solved;
    double clearance = 0.0; ///< (b - |h|)/b with h = c - a sin θ2
    std::array<TwoPart, kPlottedChannels.size()> values{};
    std::array<double, kPlottedChannels.size()> kappa{}; ///< see conditioning() in exact_motion.h
};

/// Computes the exact motion at time t (s).
ExactValues exactValues(const Parameters &parameters, double t);

} // namespace slidercrank
