// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/axis_scale.h"

#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

double largestMagnitude(const Interval &range)
{
    return std::max(std::abs(range.lower), std::abs(range.upper));
}

} // namespace

QString AxisScale::label(double value) const
{
    if (isLogarithmic) {
        return powerOfTenText(static_cast<int>(std::lround(value)));
    }
    return numberText(std::abs(value) < step * 1e-6 ? 0.0 : value, digits); // 0 instead of the rounding error of a step
}

int AxisScale::labelLength(const Interval &range) const
{
    qsizetype length = 0;
    for (const double value : {range.lower, range.lower + step, range.upper - step, range.upper}) {
        length = std::max(length, label(std::round(value / step) * step).size());
    }
    return static_cast<int>(length);
}

AxisScale axisScale(const Interval &range, double intervals)
{
    constexpr double kFewest = 6.0;
    constexpr double kMost = 17.0;
    const double step = nextRoundNumber(range.length() / std::max(intervals, 1.0));
    const double places =
        std::ceil(std::log10(largestMagnitude(range) / step)) + 1.0; // not finite if the range underflows
    return {.step = step, .digits = static_cast<int>(std::min(std::max(kFewest, places), kMost))};
}

AxisScale degreeScale(const Interval &range, double intervals)
{
    const double wanted = range.length() / std::max(intervals, 1.0);
    AxisScale scale = axisScale(range, intervals);
    for (const double part : {180.0, 90.0, 45.0, 30.0, 15.0, 10.0}) { // of a turn
        if (wanted <= part && wanted > 5.0) {
            scale.step = part;
        }
    }
    if (wanted > 180.0) {
        scale.step = 360.0 * std::max(1.0, nextRoundNumber(wanted / 360.0));
    }
    return scale;
}

AxisScale logarithmicScale(const Interval &range, double intervals)
{
    return {.step = std::max(1.0, axisScale(range, intervals).step), .isLogarithmic = true};
}

Interval roundedOutwards(const Interval &range)
{
    const double largest = largestMagnitude(range);
    // A relative difference below this limit is a rounding error.
    constexpr double kSmallestPart = 1e-12;
    if (!(range.length() > kSmallestPart * largest)) {
        const double half = largest > 0.0 ? 0.1 * largest : 1.0;
        const double middle = 0.5 * range.lower + 0.5 * range.upper;
        return roundedOutwards({middle - half, middle + half});
    }
    constexpr double kMargin = 0.03;
    constexpr double kParts = 16.0;
    const double step = nextRoundNumber(range.length() / kParts);
    const double margin = kMargin * range.length();
    // A margin below zero would suggest negative values.
    const double lower = range.lower == 0.0 ? 0.0 : std::floor((range.lower - margin) / step) * step;
    return {lower, std::ceil((range.upper + margin) / step) * step};
}

} // namespace slidercrank
