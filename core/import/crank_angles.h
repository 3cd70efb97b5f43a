// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files that count by the crank's angle instead of the time, as tables of textbooks and engines do: which column it is,
// how its numbers go on from turn to turn, and the instants that follow from it for a crank of a given drive:
//
//     t = (θ2 - θ20) / ω2
//
// Positions by angle do not depend on the drive, nor does what they are compared with; derivatives by the time do.

#include "core/import/reference_data.h"
#include "core/mechanism/mechanism.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace slidercrank
{

/// "deg", "rad", "°CA", or empty for degrees: how many make a degree. None for another unit.
std::optional<double> unitsPerDegree(const std::string &unit);

/// Without the jumps of angles that are kept within a turn: 359, 0, 1 go on as 359, 360, 361. As they are where they go
/// one way throughout already.
std::vector<double> goingOn(std::vector<double> degrees);

/// The first that does not follow the one before in the direction of the first two; none where all go one way.
std::optional<std::size_t> turnsBackAt(std::span<const double> degrees);

/// The data with the instants at which that mechanism's crank comes to the file's angles; rows change their order where
/// it turns the other way. Data with instants of their own stay as they are. None where there are no such instants: the
/// crank stands still, or turns so slowly or so fast that no doubles tell them apart.
std::optional<ReferenceData> timedBy(const Mechanism &mechanism, ReferenceData data);

} // namespace slidercrank
