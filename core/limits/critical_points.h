// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The critical points of each plotted channel over a turn of the crank: extrema, and the ends of its motion. Between
// two of them the channel only rises or only falls, so that its extremes over any time are among them and the values at
// the beginning and at the end of that time. Lengths in mm, angles in rad, time in s.
//
// Extrema are the zeros of the next derivative, not the largest of some samples; near a toggle the search is as fine as
// the motion is narrow there, √(ε/a) rad.

#include "core/mechanism/channel.h"

#include <array>
#include <vector>

namespace slidercrank
{

struct CriticalPoint {
    /// As the crank angle grows, a channel begins and ends at the limits of a rocker; at an exact toggle, where the
    /// velocities jump, it ends and begins again.
    enum class Kind { End, Begin, Extremum };

    double theta2 = 0.0; ///< within [-π, π)
    double value = 0.0;  ///< ±∞ for the derivatives at a rocker's limit
    Kind kind = Kind::Extremum;
};

/// In ascending order of the crank angle; empty if there is no motion.
using CriticalPoints = std::vector<CriticalPoint>;

/// In the order of kPlottedChannels.
std::array<CriticalPoints, kPlottedChannels.size()> findCriticalPoints(const Mechanism &mechanism);

} // namespace slidercrank
