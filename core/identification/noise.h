// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tells independent errors from systematic ones by the signs of the residuals.

#include "core/identification/observations.h"

#include <cmath>

namespace slidercrank
{

/// Whether residuals change their sign as often as independent errors do, within three standard deviations: from row to
/// row in half of the pairs of rows.
inline bool changeSignLikeNoise(const Values &residuals)
{
    const Index pairs = residuals.size() - 1;
    const auto product = residuals.head(pairs) * residuals.tail(pairs); // NaN beside a gap
    const double changes = static_cast<double>((product < 0.0).count());
    const double all = static_cast<double>((product < 0.0).count() + (product >= 0.0).count());
    return changes > 0.5 * all - 3.0 * 0.5 * std::sqrt(all);
}

} // namespace slidercrank
