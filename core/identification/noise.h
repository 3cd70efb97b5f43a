// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tells independent errors from systematic ones by the signs of the residuals of a column.

#include "core/identification/observations.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

/// How many standard errors a value may be from the true one. Of 400 values with normally distributed errors, one is
/// farther away.
inline constexpr double kStandardErrors = 3.0;

/// How many residuals prove as much as one independent residual: 1 for noise, whose sign changes in every second row on
/// average; more for systematic residuals, which keep their sign for some rows.
inline double dependence(const Values &residuals)
{
    double runs = 1.0; // number of series of residuals with the same sign
    double count = 0.0;
    double previous = 0.0;
    for (const double residual : residuals) {
        if (std::isfinite(residual)) {
            runs += residual * previous < 0.0 ? 1.0 : 0.0;
            count += 1.0;
            previous = residual;
        }
    }
    return std::max(1.0, 0.5 * count / runs);
}

/// Whether residuals change their sign from row to row as often as independent errors do: in half of the pairs of
/// neighbouring rows, or less often by no more than three standard deviations of that number.
inline bool changeSignLikeNoise(const Values &residuals)
{
    const Index pairs = residuals.size() - 1;
    const Values product = residuals.head(pairs) * residuals.tail(pairs); // NaN beside a gap
    const double changes = static_cast<double>((product < 0.0).count());
    const double pairsWithValues = changes + static_cast<double>((product >= 0.0).count());
    // The number of changes of independent errors has a binomial distribution with the probability 1/2.
    const double expectedChanges = 0.5 * pairsWithValues;
    const double standardDeviation = 0.5 * std::sqrt(pairsWithValues);
    return changes > expectedChanges - kStandardErrors * standardDeviation;
}

/// Whether residuals without gaps differ from row to row as much as independent errors of one size do: the mean square
/// of the differences is twice that of the residuals (von Neumann's ratio), or less by no more than three standard
/// deviations. In few rows, this finds curves that changeSignLikeNoise() does not.
inline bool differLikeNoise(const Values &residuals)
{
    const Index pairs = residuals.size() - 1;
    const double squareOfDifferences = (residuals.tail(pairs) - residuals.head(pairs)).square().mean();
    const double standardDeviation = 2.0 / std::sqrt(static_cast<double>(pairs));
    return squareOfDifferences > (2.0 - kStandardErrors * standardDeviation) * residuals.square().mean();
}

} // namespace slidercrank
