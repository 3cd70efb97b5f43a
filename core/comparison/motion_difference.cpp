// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/comparison/motion_difference.h"

#include "core/closed_form/closed_form.h"
#include "core/limits/critical_points.h"
#include "core/mechanism/turn.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

constexpr std::size_t kCount = kPlottedChannels.size();
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

using Columns = std::array<std::vector<double>, kCount>;

/// NaN: does not exist.
Columns columnsOf(const ClosedForm &motion, std::span<const double> instants)
{
    Columns columns;
    for (std::vector<double> &column : columns) {
        column.resize(instants.size());
    }
    std::vector<Status> statuses(instants.size());
    motion.evaluate(instants,
                    {columns[0].data(), columns[1].data(), columns[2].data(), columns[3].data(), columns[4].data(),
                     columns[5].data()},
                    statuses);
    for (std::size_t channel = 0; channel < kCount; ++channel) {
        toFileUnit(kPlottedChannels[channel], columns[channel]);
    }
    return columns;
}

/// Enough to a turn that nothing of a motion is between two of them but its largest value to the last digits.
std::vector<double> instantsOf(const Mechanism &one, const Mechanism &other, double from, double to)
{
    constexpr double kPerTurn = 500.0;
    constexpr double kMost = 20'011.0; // a prime, so that they come by all phases of the turns that they skip
    const double speed = std::max(std::abs(one.omega2()), std::abs(other.omega2()));
    double turns = (to - from) * speed / kTurn;
    if (turns * kPerTurn > kMost && one.omega2() == other.omega2()) {
        to = from + kTurn / speed;
        turns = 1.0;
    }
    const double pieces = std::ceil(std::clamp(turns * kPerTurn, kPerTurn, kMost));
    std::vector<double> instants;
    instants.reserve(static_cast<std::size_t>(pieces) + 1);
    for (double i = 0.0; i <= pieces; ++i) {
        instants.push_back(from + (to - from) * i / pieces);
    }
    return instants;
}

/// When, from one instant to the other, the channel first is infinite.
std::optional<double> unboundedAt(const Mechanism &mechanism, const CriticalPoints &course, double from, double to)
{
    std::optional<double> first;
    const double omega2 = mechanism.omega2();
    for (const CriticalPoint &point : course) {
        if (std::isfinite(point.value) || omega2 == 0.0) {
            continue;
        }
        const double period = kTurn / std::abs(omega2);
        const double passage = (point.theta2 - mechanism.theta20()) / omega2;
        const double t = passage + period * std::ceil((from - passage) / period);
        if (t <= to && (!first || t < *first)) {
            first = t;
        }
    }
    return first;
}

} // namespace

MotionDifference differenceOf(const Mechanism &one, const Mechanism &other, double from, double to)
{
    if (to < from) {
        std::swap(from, to);
    }
    const ClosedForm oneMotion(one);
    const ClosedForm otherMotion(other);
    const std::vector<double> instants = instantsOf(one, other, from, to);
    const Columns ofOne = columnsOf(oneMotion, instants);
    const Columns ofOther = columnsOf(otherMotion, instants);
    const auto oneCourses = findCriticalPoints(one);
    const auto otherCourses = findCriticalPoints(other);
    MotionDifference difference;
    for (std::size_t channel = 0; channel < kCount; ++channel) {
        ChannelDifference &found = difference.channels[channel];
        found.channel = kPlottedChannels[channel];
        double weights = 0.0;
        double squares = 0.0;
        std::size_t largest = 0;
        for (std::size_t i = 0; i < instants.size(); ++i) {
            const double error = std::abs(ofOne[channel][i] - ofOther[channel][i]);
            if (std::isfinite(ofOther[channel][i])) {
                found.peak = std::max(found.peak, std::abs(ofOther[channel][i]));
            }
            if (!std::isfinite(error)) {
                difference.hasGaps = difference.hasGaps || found.channel.order == Order::Position;
                continue;
            }
            const double weight = i == 0 || i + 1 == instants.size() ? 0.5 : 1.0;
            weights += weight;
            squares += weight * error * error;
            if (!found.maxAbs || error > *found.maxAbs) {
                found.maxAbs = error;
                largest = i;
            }
        }
        if (!found.maxAbs) {
            continue;
        }
        const auto oneInfinite = unboundedAt(one, oneCourses[channel], from, to);
        const auto otherInfinite = unboundedAt(other, otherCourses[channel], from, to);
        if (otherInfinite) {
            found.peak = kUnbounded;
        }
        if (oneInfinite || otherInfinite) {
            found.maxAbs = kUnbounded;
            found.timeOfMaxAbs = std::min(oneInfinite.value_or(to), otherInfinite.value_or(to));
            continue;
        }
        const auto minusDifference = [&](double t) {
            const double there = std::abs(columnsOf(oneMotion, {&t, 1})[channel].front() -
                                          columnsOf(otherMotion, {&t, 1})[channel].front());
            return std::isfinite(there) ? -there : 0.0;
        };
        constexpr int kHalfOfTheBits = 26; // a minimum is not told more sharply
        std::uintmax_t looks = 50;
        const auto [time, least] = boost::math::tools::brent_find_minima(
            minusDifference, instants[largest > 0 ? largest - 1 : 0],
            instants[std::min(largest + 1, instants.size() - 1)], kHalfOfTheBits, looks);
        found.timeOfMaxAbs = -least > *found.maxAbs ? time : instants[largest];
        found.maxAbs = std::max(*found.maxAbs, -least);
        found.rms = std::sqrt(squares / weights);
        if (found.peak > 0.0) {
            constexpr double kPercent = 100.0;
            found.percentOfPeak = *found.maxAbs / found.peak * kPercent;
        }
    }
    return difference;
}

} // namespace slidercrank
