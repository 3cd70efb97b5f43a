// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds out by the values of columns which body they belong to, where their headings leave it open: only the crank
// turns evenly or by more than half a turn, and only the slider does not turn at all.

#include "core/import/raw_table.h"

#include <vector>

namespace slidercrank
{

/// Reassigns candidates of unnamed bodies to the body to which they belong, and removes those that belong to none. The
/// candidates have the default units, and the channel that is usual for their headings.
void assignBodies(RawTable &table, std::vector<RawColumn *> &candidates);

} // namespace slidercrank
