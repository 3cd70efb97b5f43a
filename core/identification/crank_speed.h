// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Candidates for the speed of the crank, from the columns alone, and the test whether that speed is constant.

#include "core/identification/diagnosis.h"
#include "core/identification/observations.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// Candidates for |ω2| in rad/s; for a file by crank angle, in radians of the crank per radian of the file.
struct SpeedCandidates {
    std::vector<double> periodic; ///< if the file spans more than 0.7 turns; the best first
    std::vector<double> shortArc; ///< to be tried as well if the file may span less than a turn; else empty
    bool isKnown = false;         ///< read from θ2 or its speed, or the file counts by the crank angle
};

/// From θ2 if the file has it, else from a periodogram of two harmonics of every column that tells the shape.
SpeedCandidates speedCandidates(const Observations &data);

/// Roughly the number of turns that the file spans: by θ2, or else by how often the columns cross their means.
double roughTurns(const Observations &data);

/// The crank's speed at both ends of the file if θ2 does not advance evenly and the two speeds differ by more than
/// their own uncertainty.
std::optional<CrankSpeedChange> crankSpeedChange(const Observations &data);

} // namespace slidercrank
