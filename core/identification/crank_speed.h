// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How fast the crank may turn, from the columns alone; and whether it turns evenly.

#include "core/identification/diagnosis.h"
#include "core/identification/observations.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// Candidates for |ω2| in rad/s, by crank angle in rad of the crank per rad of the file.
struct SpeedCandidates {
    std::vector<double> periodic; ///< of more than 0.7 turns, the best first
    std::vector<double> shortArc; ///< to be tried as well where the file may be of less than a turn
    bool isKnown = false;         ///< read from θ2 or its speed, or the file counts by the crank angle
};

/// From θ2 where the file has it, else from a periodogram of two harmonics of every column that tells the shape.
SpeedCandidates speedCandidates(const Observations &data);

/// About how many turns the file spans: by θ2, else from how often the columns cross their means.
double roughTurns(const Observations &data);

/// The crank's speed at either end, where θ2 does not advance evenly and the two speeds differ by more than their own
/// uncertainty.
std::optional<CrankSpeedChange> crankSpeedChange(const Observations &data);

} // namespace slidercrank
