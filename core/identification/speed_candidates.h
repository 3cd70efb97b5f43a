// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Candidates for the speed of the crank, in a file without its angle.

#include "core/identification/observations.h"

#include <vector>

namespace slidercrank
{

/// Returns candidates for |ω2|, rad/s, the most likely one first. `columns`: those from which the geometry is to be
/// found.
///
/// A column crosses the middle of its range twice per turn, or more often, which limits the number of turns. The
/// candidates are the best minima of a periodogram: for each speed, a constant and two harmonics are fitted to all
/// columns (N. Lomb, Astrophys. Space Sci. 39, 1976). If there may be less than one turn, harmonics explain any speed;
/// then speeds from one and a half turns down to a twentieth of a turn in the file follow.
std::vector<double> findSpeedCandidates(const Observations &observations, const Indices &columns);

} // namespace slidercrank
