// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the fits start: shapes b = 1, a/b, c/b with a speed and a crank angle whose motion is like the columns up to a
// free scale and origin of each. So the search is blind to units, signs and origins, and one fit serves them all.

#include "core/identification/crank_speed.h"
#include "core/identification/fit.h"

#include <cstddef>
#include <stop_token>
#include <vector>

namespace slidercrank
{

struct ShapeSearchOptions {
    std::size_t coarseRows = 40; ///< on which the grid is compared
    std::size_t fitRows = 80;
    std::stop_token stop;
};

/// How unlike the columns the nearest shape of a coarse grid is: Σ n ln(1 − ρ²).
double leastDissimilarity(const Observations &data, const std::vector<ColumnUse> &columns,
                          const SpeedCandidates &speeds, std::size_t rows);

/// Fits with free scales and origins, distinct from each other, the best score first. `columns`: which channel each
/// column is taken for.
std::vector<Fit> searchShapes(const Observations &data, const std::vector<ColumnUse> &columns,
                              const SpeedCandidates &speeds, const ShapeSearchOptions &options);

} // namespace slidercrank
