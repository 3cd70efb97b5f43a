// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/axis_scale.h"

#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

Interval roundedOutwards(const Interval &range)
{
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    // A relative difference below this limit is a rounding error.
    constexpr double kMinRangeFraction = 1e-12;
    if (!(range.length() > kMinRangeFraction * largest)) {
        constexpr double kHalfFraction = 0.1; // of the value
        const double half = largest > 0.0 ? kHalfFraction * largest : 1.0;
        const double middle = 0.5 * range.lower + 0.5 * range.upper;
        return roundedOutwards({middle - half, middle + half});
    }
    constexpr double kMargin = 0.03;
    constexpr double kMaxSteps = 16.0;
    const double step = nextRoundNumber(range.length() / kMaxSteps);
    const double margin = kMargin * range.length();
    // A margin below zero would suggest negative values.
    const double lower = range.lower == 0.0 ? 0.0 : std::floor((range.lower - margin) / step) * step;
    return {lower, std::ceil((range.upper + margin) / step) * step};
}

} // namespace slidercrank
