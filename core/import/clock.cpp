// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/clock.h"

#include "core/import/value_sequence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

/// Returns the numbers 0, 1, 2, … of time stamps without gaps.
std::vector<double> numbersWithoutGaps(std::size_t count)
{
    std::vector<double> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0.0);
    return numbers;
}

/// Returns the number of each time stamp on a grid whose spacing is the lower quartile of the differences, from 0. Some
/// time stamps of the grid may be missing. Returns nothing unless most neighbours are one spacing apart.
std::vector<double> numbersWithGaps(std::span<const double> time)
{
    constexpr double kMaxGapFraction =
        0.5; // of all differences: time stamps that a person chose have a grid, too, but more gaps
    std::vector<double> differences;
    differences.reserve(time.size());
    for (std::size_t i = 1; i < time.size(); ++i) {
        differences.push_back(time[i] - time[i - 1]);
    }
    std::vector<double> sorted = differences;
    std::ranges::sort(sorted);
    const double step = sorted.empty() ? 0.0 : sorted[sorted.size() / 4]; // the smallest one may be rounded down
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
    // As a fraction of the rounding step; time stamps that were rounded deviate far more from an even spacing.
    constexpr double kRelativeTolerance = 1e-3;
    constexpr double kMaxUlps = 4.0; // rounding errors of two differences: four time stamps, plus the unit conversion
    constexpr double kMaxMissingFraction = 0.2; // of the time stamps: a grid that lacks more is not the true one
    constexpr std::size_t kMinTimeStamps = 10;  // fewer may be evenly spaced by chance
    Clock clock;
    if (time.empty()) {
        return clock;
    }
    const double latest = std::max(std::abs(time.front()), std::abs(time.back()));
    clock.printedStep = rounding.stepAt(latest);
    const double slack = std::max(kRelativeTolerance * clock.printedStep, kMaxUlps * kEpsilon * latest);
    const std::vector<double> numbers = numbersWithGaps(time);
    const bool hasGaps = numbers.empty() || numbers.back() + 1.0 > static_cast<double>(numbers.size());
    const bool mayBeGrid = !numbers.empty() && (!hasGaps || time.size() >= kMinTimeStamps);
    ValueRange spacing; // per step of the grid
    for (std::size_t i = 1; mayBeGrid && i < time.size(); ++i) {
        spacing.include((time[i] - time[i - 1]) / (numbers[i] - numbers[i - 1]));
    }
    // If a grid lacks many time stamps, but they are evenly spaced within their rounding, they were rounded:
    // 0, 0.01, 0.03, 0.04, 0.06 is 0, 0.014, 0.028, 0.042, 0.056, and not a grid of 0.01 that lacks every third one.
    const double missing = numbers.empty() ? 0.0 : numbers.back() + 1.0 - static_cast<double>(time.size());
    const bool isRatherRounded = missing > kMaxMissingFraction * static_cast<double>(time.size()) &&
                                 time.size() >= kMinTimeStamps &&
                                 isStraight(time, numbersWithoutGaps(time.size()), clock.printedStep);
    clock.isEven = time.size() == 1 || (mayBeGrid && spacing.width() <= slack && !isRatherRounded);
    clock.printedStep = clock.isEven ? rounding.finestStep() : clock.printedStep;
    if (clock.isEven || time.size() < kMinTimeStamps) {
        return clock;
    }
    // If the rounding step is not much smaller than the spacing (0.02, 0.05, 0.07 for 0.025, 0.05, 0.075), the
    // differences look like gaps, so that a grid without gaps is tried first.
    for (std::vector<double> grid : {numbersWithoutGaps(time.size()), numbers}) {
        // Each time stamp may be off by half a step, and so may the first and the last, which determine the spacing.
        if (!grid.empty() && isStraight(time, grid, clock.printedStep)) {
            clock.isRoundedGrid = true;
            clock.gridNumbers = std::move(grid);
            break;
        }
    }
    return clock;
}

} // namespace slidercrank
