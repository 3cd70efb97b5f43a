// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The peaks of Ṙ4x, R̈4x, θ̇3 and θ̈3 over a whole turn of the crank, whichever part of it is sampled, and the crank
// angles at which they are reached. Lengths in mm, angles in rad, time in s.

#include "core/mechanism/channel.h"

#include <vector>

namespace slidercrank
{

/// A crank angle at which a peak is reached.
struct PeakPlace {
    double theta2 = 0.0; ///< within [-π, π)
    double value = 0.0;  ///< with its sign; +∞ where the peak is unbounded
};

struct Peak {
    Channel channel;

    /// Largest |value|. Infinite if the motion reaches a limit of a rocker, and for accelerations if it passes an exact
    /// toggle, where the velocity jumps.
    double magnitude = 0.0;

    /// All crank angles at which it is reached, or grows without bound, ascending; symmetric motions reach it more than
    /// once. A velocity that is largest next to an exact toggle is reached in the limit only. Empty if the value is the
    /// same everywhere: zero for ω2 = 0, and |ω2| for the coupler of a = b, c = 0.
    std::vector<PeakPlace> places;
};

/// Of the slider's velocity and acceleration, then the coupler's; empty if nothing can move (locked, impossible).
std::vector<Peak> motionPeaks(const Mechanism &mechanism);

} // namespace slidercrank
