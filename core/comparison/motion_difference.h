// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far one mechanism's exact motion is from another's during a run: what changes when a length does. Of many more
// instants than anybody's samples, the largest difference sought between them. In the units of the author's files (mm,
// °, s); a difference is the one minus the other.

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"

#include <array>
#include <optional>

namespace slidercrank
{

struct ChannelDifference {
    Channel channel;

    // Absent where the two motions never exist at once.
    std::optional<double> maxAbs; ///< ∞ where one of them grows beyond all bounds
    double timeOfMaxAbs = 0.0;    ///< s
    std::optional<double> rms;    ///< absent as well where maxAbs is ∞

    double peak = 0.0;                   ///< the other's largest magnitude; ∞ as above
    std::optional<double> percentOfPeak; ///< maxAbs of it, where both are finite
};

struct MotionDifference {
    std::array<ChannelDifference, kPlottedChannels.size()> channels; ///< as in kPlottedChannels
    bool hasGaps = false; ///< at some instants one of them cannot be assembled
};

/// From one instant (s) to the other, whichever is earlier. Of so many turns that they are not worth the time, where
/// both cranks turn alike, the first stands for all.
MotionDifference differenceOf(const Mechanism &one, const Mechanism &other, double from, double to);

} // namespace slidercrank
