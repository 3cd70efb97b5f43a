// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the peaks of Ṙ4x, R̈4x, θ̇3 and θ̈3 over a full revolution of the crank, independent of the sampling, and the
// crank angles at which they occur. Lengths in mm, angles in rad, time in s.

#include "core/mechanism/channel.h"

#include <array>
#include <vector>

namespace slidercrank
{

/// The channels whose peaks are computed.
inline constexpr std::array<Channel, 4> kPeakChannels{
    {{R4x, Order::Velocity}, {R4x, Order::Acceleration}, {Theta3, Order::Velocity}, {Theta3, Order::Acceleration}}};

/// A crank angle at which a peak occurs.
struct PeakPoint {
    double theta2 = 0.0; ///< within [-π, π)
    double value = 0.0;  ///< with its sign; +∞ if the peak is unbounded
};

struct Peak {
    Channel channel = {};

    /// The largest |value|. Infinite if the motion reaches a limit position of a rocker; for accelerations also if the
    /// motion passes an exact toggle, where the velocity jumps.
    double magnitude = 0.0;

    /// All crank angles at which the peak occurs or the value is unbounded, ascending. Symmetric motions have several.
    /// A velocity that is largest next to an exact toggle attains its peak only in the limit. Empty if the value is
    /// constant: zero for ω2 = 0, and |ω2| for the coupler of a = b, c = 0.
    std::vector<PeakPoint> points = {};
};

/// Returns the peaks, in the order of kPeakChannels; empty if the mechanism cannot move (locked, impossible).
std::vector<Peak> motionPeaks(const Mechanism &mechanism);

} // namespace slidercrank
