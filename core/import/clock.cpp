// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/clock.h"

#include "core/import/reference_data.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

/// Instants of nine digits are uneven in the last one, and values of nine digits show it.
constexpr double kEvenPartOfStep = 1e-3;

/// A double's own rounding: half a unit in the last place of either instant, twice for two differences, and as much for
/// a change of unit.
constexpr double kUlpsOfADifference = 4.0;

/// Fewer may lie so by chance.
constexpr std::size_t kInstantsOfAGrid = 10;

/// Each instant is off by half a step at most, and so are the first and the last, between which the others are held.
bool isRoundedGrid(std::span<const double> time, double step)
{
    const double spacing = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (!(std::abs(time.front() + spacing * static_cast<double>(i) - time[i]) <= step)) {
            return false;
        }
    }
    return true;
}

} // namespace

Clock clockOf(std::span<const double> time, const Rounding &rounding)
{
    Clock clock;
    if (time.empty()) {
        return clock;
    }
    const double latest = std::max(std::abs(time.front()), std::abs(time.back()));
    clock.printedStep = rounding.stepAt(latest);
    const double slack = std::max(kEvenPartOfStep * clock.printedStep,
                                  kUlpsOfADifference * std::numeric_limits<double>::epsilon() * latest);
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (std::size_t i = 1; i < time.size() && clock.even; ++i) {
        const double difference = time[i] - time[i - 1];
        least = std::min(least, difference);
        most = std::max(most, difference);
        clock.even = most - least <= slack;
    }
    clock.printedStep = clock.even ? rounding.finestStep() : clock.printedStep;
    clock.rounded = !clock.even && time.size() >= kInstantsOfAGrid && isRoundedGrid(time, clock.printedStep);
    return clock;
}

Clock clockOf(const ReferenceData &data)
{
    return clockOf(data.time, data.timeRounding);
}

} // namespace slidercrank
