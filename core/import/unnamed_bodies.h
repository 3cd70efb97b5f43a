// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds out by the values of columns which body they belong to, where their headings leave it open: only the crank
// turns evenly or by more than half a turn, and only the slider does not turn at all.

#include "core/import/raw_table.h"

#include <vector>

namespace slidercrank
{

/// Corrects meanings that the values disprove, before the time or crank angle is known: of "α", which is also an angle,
/// of angles whose links are numbered from the crank instead of the frame, and of velocities beside a y without an x.
void correctMeanings(RawTable &table);

/// Reassigns candidates of unnamed bodies to the body to which they belong, and removes those that belong to none. The
/// candidates have the default units, and the channel that is usual for their headings.
void assignBodies(RawTable &table, std::vector<RawColumn *> &candidates);

/// Returns whether the column only rises or only falls as an angle that is limited to one turn.
bool isTurningAngle(const RawColumn &column);

/// Returns whether all readable values of at least ten rows are equal.
bool isConstant(const RawColumn &column);

} // namespace slidercrank
