// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the crank angles at which a quantity has a given value, and the crank speed at which a velocity has one.
// Lengths in mm, angles in rad, time in s.
//
// A quantity is monotone between two successive critical points (critical_points.h), so that each of these pieces holds
// at most one solution, which bisection finds to the last digit of the crank angle.

#include "core/limits/output_channel.h"

#include <cmath>
#include <optional>
#include <vector>

namespace slidercrank
{

/// Returns all crank angles within [-π, π), ascending, at which the channel has the value (mm, rad, s) if the crank has
/// the acceleration alpha2 (rad/s²) there. An angle is compared modulo a turn, as a direction. A value that equals an
/// extremum except for rounding has the single solution there. A value that the channel keeps over an arc, such as
/// x = 0 for a = b and c = 0, has the two ends of the arc as solutions. Returns nullopt if the channel does not depend
/// on the crank angle, such as R4_y, or a velocity for ω2 = 0.
std::optional<std::vector<double>> crankAnglesAt(const Mechanism &mechanism, const OutputChannel &channel, double value,
                                                 double alpha2 = 0.0);

/// The smallest and the largest value of a channel over a revolution (mm, rad, s).
struct ChannelRange {
    double least = 0.0;
    double greatest = 0.0;

    /// Returns whether the range is finite and the value is beyond it. A rocker also misses some values within the
    /// range.
    bool excludes(double value) const
    {
        return std::isfinite(least) && std::isfinite(greatest) && (value < least || value > greatest);
    }
};

/// Returns the range of a channel if the crank has the acceleration alpha2 (rad/s²). A bound is infinite if
/// a derivative is, at a limit position of a rocker. Returns nullopt where crankAnglesAt() does, if there is no motion,
/// and for the crank angle and the transmission angle.
std::optional<ChannelRange> rangeOf(const Mechanism &mechanism, const OutputChannel &channel, double alpha2 = 0.0);

/// Returns the crank speed (rad/s) at which a first derivative has the value at the crank angle theta2 (rad), or
/// nullopt if it is zero at any speed there, such as the slider's velocity at a dead centre, or does not exist.
/// Requires a channel of Order::Velocity.
std::optional<double> crankSpeedFor(const Mechanism &mechanism, double theta2, const OutputChannel &channel,
                                    double value);

} // namespace slidercrank
