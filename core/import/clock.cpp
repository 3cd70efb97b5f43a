// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/clock.h"

#include "core/import/crank_angles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slidercrank
{

Clock clockOf(std::span<const double> time, const Rounding &rounding)
{
    constexpr double kPartOfStep = 1e-3; // nine digits are uneven in the last one, and nine-digit values show it
    constexpr double kUlps = 4.0;        // of the two time stamps of two differences, and of a unit conversion
    constexpr std::size_t kFewestTimeStamps = 10; // fewer may be evenly spaced by chance
    Clock clock;
    if (time.empty()) {
        return clock;
    }
    const double latest = std::max(std::abs(time.front()), std::abs(time.back()));
    clock.printedStep = rounding.stepAt(latest);
    const double slack = std::max(kPartOfStep * clock.printedStep, kUlps * kEpsilon * latest);
    ValueRange differences;
    for (std::size_t i = 1; i < time.size() && clock.even; ++i) {
        differences.include(time[i] - time[i - 1]);
        clock.even = differences.width() <= slack;
    }
    clock.printedStep = clock.even ? rounding.finestStep() : clock.printedStep;
    if (!clock.even && time.size() >= kFewestTimeStamps) {
        // Each time stamp may be off by half a step, and so may the first and the last, which determine the spacing.
        std::vector<double> rows(time.size());
        std::iota(rows.begin(), rows.end(), 0.0);
        clock.rounded = isStraight(time, rows, clock.printedStep);
    }
    return clock;
}

} // namespace slidercrank
