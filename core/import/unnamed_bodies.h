// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the bodies of columns by their values if the headings leave them open: only the crank turns evenly or by more
// than half a turn, and only the slider does not turn at all.

#include "core/import/raw_table.h"

#include <vector>

namespace slidercrank
{

/// Sets the channels of candidates of unnamed bodies to the bodies to which they belong, and removes those that belong
/// to none of the three bodies or whose body remains unknown, with their reasons. The candidates have the default
/// units, and the channel that is usual for their headings.
void assignBodies(RawTable &table, std::vector<RawColumn *> &candidates);

} // namespace slidercrank
