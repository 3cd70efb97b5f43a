// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Searches the starts of all fits: shapes (a/b, c/b with b = 1) with a speed and a crank angle whose motion fits the
// columns up to a free scale and origin of each. The search thus does not depend on units, signs and origins.

#include "core/identification/crank_speed.h"
#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// Returns distinct fits with free scales and origins, from best to worst. `columns`: the channel of each column.
std::vector<Fit> searchShapes(const Observations &data, const std::vector<ColumnUse> &columns,
                              const SpeedCandidates &speeds);

} // namespace slidercrank
