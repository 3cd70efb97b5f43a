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

constexpr std::size_t kMinTimeStamps = 10; // fewer may be evenly spaced by chance

/// Returns the numbers 0, 1, 2, … of time stamps without gaps.
std::vector<double> numbersWithoutGaps(std::size_t count)
{
    std::vector<double> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0.0);
    return numbers;
}

/// Returns the number of each time stamp on a grid whose spacing is the lower quartile of the differences, from 0. Some
/// time stamps of the grid may be missing. Returns no numbers unless most neighbours are one spacing apart.
std::vector<double> numbersWithGaps(std::span<const double> time)
{
    constexpr double kMaxGapFraction = 0.5; // of all differences: with more, a person chose the time stamps
    std::vector<double> differences;
    differences.reserve(time.size());
    for (std::size_t i = 1; i < time.size(); ++i) {
        differences.push_back(time[i] - time[i - 1]);
    }
    std::vector<double> sorted = differences;
    std::ranges::sort(sorted);
    const double spacing = sorted.empty() ? 0.0 : sorted[sorted.size() / 4]; // the smallest one may be rounded down
    std::vector<double> numbers;
    numbers.reserve(time.size());
    numbers.push_back(0.0);
    std::size_t gaps = 0;
    for (const double difference : differences) {
        const double spacings = std::round(difference / spacing);
        gaps += spacings == 1.0 ? 0 : 1;
        numbers.push_back(numbers.back() + spacings);
    }
    const bool isGrid = static_cast<double>(gaps) < kMaxGapFraction * static_cast<double>(differences.size());
    return isGrid ? numbers : std::vector<double>();
}

/// Returns whether time stamps that have these numbers on a grid are evenly spaced, apart from `tolerance` (s). Returns
/// false without numbers, or for fewer than kMinTimeStamps time stamps with gaps.
bool areEvenlySpaced(std::span<const double> time, const std::vector<double> &numbers, double tolerance)
{
    if (numbers.empty()) {
        return false;
    }
    ValueRange spacing; // of the grid, s
    for (std::size_t i = 1; i < time.size(); ++i) {
        spacing.include((time[i] - time[i - 1]) / (numbers[i] - numbers[i - 1]));
    }
    const bool hasGaps = numbers.back() + 1.0 > static_cast<double>(numbers.size());
    return spacing.width() <= tolerance && (!hasGaps || time.size() >= kMinTimeStamps);
}

/// Returns whether time stamps were rounded, although they have numbers on a grid: the grid lacks many, and numbered
/// without gaps, they are evenly spaced within their rounding. 0, 0.01, 0.03, 0.04, 0.06 is 0, 0.014, 0.028, 0.042,
/// 0.056, and not a grid of 0.01 that lacks every third time stamp.
bool areRatherRounded(std::span<const double> time, const std::vector<double> &numbers, double printedStep)
{
    constexpr double kMaxMissingFraction = 0.2; // of the time stamps: a grid that lacks more is not the true one
    const double missing = numbers.empty() ? 0.0 : numbers.back() + 1.0 - static_cast<double>(time.size());
    return missing > kMaxMissingFraction * static_cast<double>(time.size()) && time.size() >= kMinTimeStamps &&
           isStraight(time, numbersWithoutGaps(time.size()), printedStep);
}

} // namespace

TimePrecision timePrecisionOf(std::span<const double> time, const Rounding &rounding)
{
    // As a fraction of the rounding step; time stamps that were rounded deviate far more from an even spacing.
    constexpr double kRelativeTolerance = 1e-3;
    constexpr double kMaxUlps = 4.0; // rounding errors of two differences: four time stamps, plus the unit conversion
    TimePrecision precision;
    if (time.empty()) {
        return precision;
    }
    const double latest = std::max(std::abs(time.front()), std::abs(time.back()));
    const double printedStep = rounding.stepAt(latest);
    const double tolerance = std::max(kRelativeTolerance * printedStep, kMaxUlps * kEpsilon * latest);
    const std::vector<double> numbers = numbersWithGaps(time);
    precision.isEven = time.size() == 1 ||
                       (areEvenlySpaced(time, numbers, tolerance) && !areRatherRounded(time, numbers, printedStep));
    precision.printedStep = precision.isEven ? rounding.finestStep() : printedStep;
    if (precision.isEven || time.size() < kMinTimeStamps) {
        return precision;
    }
    // If the rounding step is not much smaller than the spacing (0.02, 0.05, 0.07 for 0.025, 0.05, 0.075), the
    // differences look like gaps, so that a grid without gaps is tried first.
    for (std::vector<double> grid : {numbersWithoutGaps(time.size()), numbers}) {
        // Each time stamp may be off by half a step, and so may the first and the last, which determine the spacing.
        if (!grid.empty() && isStraight(time, grid, printedStep)) {
            precision.isRoundedGrid = true;
            precision.gridNumbers = std::move(grid);
            break;
        }
    }
    return precision;
}

} // namespace slidercrank
