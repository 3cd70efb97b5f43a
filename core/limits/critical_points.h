// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How each plotted channel runs over a turn of the crank: where it turns from rising to falling or back, where it
// begins and where it ends. Between one such place and the next it only rises or only falls, so that its extremes over
// any time are among them and the two instants at which that time begins and ends. Lengths in mm, angles in rad, time
// in s.
//
// The places are sought where the next derivative vanishes, not among samples; near a toggle as finely as what happens
// there is narrow, √(ε/a) rad.

#include "core/mechanism/channel.h"

#include <array>
#include <vector>

namespace slidercrank
{

struct CriticalPoint {
    /// It begins and ends, as the crank's angle grows, at the limits of a rocker; at an exact toggle, where the speeds
    /// jump, it ends and begins anew.
    enum class Kind { End, Begin, Extremum };

    double theta2 = 0.0; ///< within [-π, π)
    double value = 0.0;  ///< ±∞ for the derivatives at a rocker's limit
    Kind kind = Kind::Extremum;
};

/// Ascending crank angles; empty where there is no motion at all.
using CriticalPoints = std::vector<CriticalPoint>;

/// As in kPlottedChannels.
std::array<CriticalPoints, kPlottedChannels.size()> findCriticalPoints(const Mechanism &mechanism);

} // namespace slidercrank
