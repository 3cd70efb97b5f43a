// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/clock.h"

#include "core/import/crank_angles.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Returns the number of each time stamp on a grid with a spacing of the smallest difference, from 0; empty unless most
/// neighbours are one step apart. Some time stamps of the grid may be missing.
std::vector<double> gridNumbers(std::span<const double> time)
{
    constexpr double kMaxGapFraction = 0.5; // of all differences: chosen time stamps also have a common divisor
    std::vector<double> differences;
    differences.reserve(time.size());
    for (std::size_t i = 1; i < time.size(); ++i) {
        differences.push_back(time[i] - time[i - 1]);
    }
    std::vector<double> sorted = differences;
    std::ranges::sort(sorted);
    const double step = sorted.empty() ? 0.0 : sorted[sorted.size() / 4]; // not the smallest one, for rounded ones
    std::vector<double> numbers;
    numbers.reserve(time.size());
    numbers.push_back(0.0);
    std::size_t gaps = 0;
    for (const double difference : differences) {
        const double steps = std::round(difference / step);
        gaps += steps == 1.0 ? 0 : 1;
        numbers.push_back(numbers.back() + steps);
    }
    const bool isGrid = static_cast<double>(gaps) < kMaxGapFraction * static_cast<double>(differences.size());
    return isGrid ? numbers : std::vector<double>();
}

} // namespace

Clock clockOf(std::span<const double> time, const Rounding &rounding)
{
    constexpr double kPartOfStep = 1e-3; // of the rounding step: rounding itself makes time stamps more uneven
    constexpr double kUlps = 4.0; // rounding errors of two differences: four time stamps, plus the unit conversion
    constexpr std::size_t kFewestTimeStamps = 10; // fewer may be evenly spaced by chance
    Clock clock;
    if (time.empty()) {
        return clock;
    }
    const double latest = std::max(std::abs(time.front()), std::abs(time.back()));
    clock.printedStep = rounding.stepAt(latest);
    const double slack = std::max(kPartOfStep * clock.printedStep, kUlps * kEpsilon * latest);
    const std::vector<double> numbers = gridNumbers(time);
    const bool hasGaps = numbers.empty() || numbers.back() + 1.0 > static_cast<double>(numbers.size());
    const bool mayBeGrid = !numbers.empty() && (!hasGaps || time.size() >= kFewestTimeStamps);
    ValueRange spacing; // per step of the grid
    for (std::size_t i = 1; mayBeGrid && i < time.size(); ++i) {
        spacing.include((time[i] - time[i - 1]) / (numbers[i] - numbers[i - 1]));
    }
    clock.even = time.size() == 1 || (mayBeGrid && spacing.width() <= slack);
    clock.printedStep = clock.even ? rounding.finestStep() : clock.printedStep;
    if (!clock.even && mayBeGrid && time.size() >= kFewestTimeStamps) {
        // Each time stamp may be off by half a step, and so may the first and the last, which determine the spacing.
        clock.rounded = isStraight(time, numbers, clock.printedStep);
    }
    return clock;
}

} // namespace slidercrank
