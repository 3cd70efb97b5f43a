// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/value_sequence.h"

#include <utility>

namespace slidercrank
{

ValueRange rangeOf(std::span<const double> values)
{
    ValueRange range;
    for (const double value : values) {
        range.include(value);
    }
    return range;
}

std::optional<std::size_t> findReversal(std::span<const double> values)
{
    const bool rises = values.size() > 1 && values[1] > values[0];
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (!(rises ? values[i] > values[i - 1] : values[i] < values[i - 1])) {
            return i;
        }
    }
    return std::nullopt;
}

bool isStraight(std::span<const double> values, std::span<const double> time, double tolerance)
{
    const double slope = (values.back() - values.front()) / (time.back() - time.front());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(std::abs(values[i] - values.front() - slope * (time[i] - time.front())) <= tolerance)) {
            return false;
        }
    }
    return true;
}

bool isParabola(std::span<const double> values, double tolerance)
{
    constexpr double kMaxErrors = 4.0; // of x[0] - 2 x[1] + x[2], in tolerances: x[1] counts twice
    ValueRange secondDifferences;
    for (std::size_t i = 2; i < values.size(); ++i) {
        secondDifferences.include(values[i] - 2.0 * values[i - 1] + values[i - 2]);
    }
    return secondDifferences.width() <= 2.0 * kMaxErrors * tolerance;
}

bool removeJumps(std::vector<double> &angles, double turn, double largestChange)
{
    std::vector<double> continuous = angles;
    double last = kNone;
    double correction = 0.0; // whole turns that are added to the values behind the last jump
    bool hadJumps = false;
    for (double &value : continuous) {
        if (!std::isfinite(value)) {
            continue;
        }
        const double change = std::isnan(last) ? 0.0 : value + correction - last;
        const double jump = turn * std::rint(change / turn);
        if (jump != 0.0 && std::abs(change - jump) > largestChange * turn) {
            return false;
        }
        hadJumps = hadJumps || jump != 0.0;
        correction -= jump;
        value += correction;
        last = value;
    }
    angles = std::move(continuous);
    return hadJumps;
}

std::vector<double> unwrapped(std::vector<double> angles, double turn)
{
    constexpr double kAnyChange = 0.5; // turns: no change is larger after the nearest whole number of turns is removed
    if (findReversal(angles)) {
        removeJumps(angles, turn, kAnyChange);
    }
    return angles;
}

double angularWidth(std::vector<double> degrees)
{
    return rangeOf(unwrapped(std::move(degrees))).width();
}

} // namespace slidercrank
