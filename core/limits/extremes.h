// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How fast slider and coupler ever get, and at which crank angles: the peaks of Ṙ4x, R̈4x, θ̇3, θ̈3 over a whole turn of
// the crank, whatever part of it was sampled. A peak of the motion is where the next derivative vanishes; it is sought
// there, not among samples. Lengths in mm, angles in rad, time in s.
//
// Near a toggle a peak is as narrow as √(ε/a) rad, ε = b - a - |c|; the search is as fine there.

#include "core/mechanism/channel.h"

#include <array>
#include <vector>

namespace slidercrank
{

/// A crank angle at which a peak is reached.
struct PeakPlace {
    double theta2 = 0.0; ///< within [-π, π)
    double value = 0.0;  ///< with its sign; +∞ where the peak is not bounded
};

struct Peak {
    Channel channel;

    /// Largest |value|. Infinite where the motion comes to a limit of a rocker, and for accelerations where it passes
    /// an exact toggle, at which the speed jumps.
    double magnitude = 0.0;

    /// Where it is reached, or grows without bound, ascending; symmetric motions reach it more than once. A speed that
    /// is largest beside an exact toggle is reached in the limit only. None where the value is the same throughout:
    /// zero for ω2 = 0, and |ω2| for the coupler of a = b, c = 0.
    std::vector<PeakPlace> places;
};

/// Of the slider's speed and acceleration, then the coupler's; none where there is no motion (locked, impossible).
std::vector<Peak> motionPeaks(const Mechanism &mechanism);

} // namespace slidercrank
