// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/comparison/comparison.h"

#include "core/import/clock.h"
#include "core/mechanism/in_parallel.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

/// Relative tolerance of a bound: decimal numbers are not exact in binary, so that a difference of exactly half a step
/// may appear larger by some units in the last place.
constexpr double kUlpSlack = 4.0 * std::numeric_limits<double>::epsilon();

constexpr std::size_t kFewestForThreads = 50000; // time stamps: below, threads cost more than they save

/// One column of the reference and the model at the same time stamps.
struct Column {
    std::span<const double> time;
    std::span<const double> model;
    const ReferenceSeries &reference;
};

/// The sizes with which the errors of a column are compared, in its unit.
struct Scale {
    double peak = 0.0; ///< largest magnitude of the reference
    double size = 0.0; ///< the larger of the peak and the channel's natural size
    double smallestStep = 0.0;
    double halfRange = 0.0; ///< of the model's motion
};

Scale scaleOf(const Column &column, const ChannelSize &channelSize)
{
    Scale scale;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = 0; i < column.time.size(); ++i) {
        const double value = column.reference.values[i];
        if (std::isfinite(value)) {
            scale.peak = std::max(scale.peak, std::abs(value));
            if (std::isfinite(column.model[i])) {
                low = std::min(low, column.model[i]);
                high = std::max(high, column.model[i]);
            }
        }
    }
    scale.size = std::max(scale.peak, channelSize.natural);
    scale.smallestStep = std::max(kArithmeticStep * scale.size,
                                  kSmallestPartOfLargestStep * column.reference.rounding.stepAt(scale.peak));
    scale.halfRange = channelSize.still > 0.0 ? channelSize.still : std::min(0.5 * high - 0.5 * low, channelSize.most);
    return scale;
}

/// The effect of rounded time stamps: the exact motion half a rounding step earlier and later.
struct RoundedTimeEffect {
    Trajectory early;
    Trajectory late;
    double largestDrift = std::numeric_limits<double>::infinity(); ///< in units of half the range

    bool isMotionPossible(Channel channel, std::size_t row) const
    {
        return std::isfinite(early[channel][row]) || std::isfinite(late[channel][row]);
    }
    double drift(Channel channel, std::size_t row, double model, double halfRange) const
    {
        const double change = std::max(std::abs(early[channel][row] - model), std::abs(late[channel][row] - model));
        const bool isBounded = std::isfinite(early[channel][row]) && std::isfinite(late[channel][row]);
        const double limit = std::isfinite(largestDrift) ? largestDrift * halfRange : largestDrift;
        return isBounded ? std::min(change, limit) : limit;
    }
};

Verdict judge(const ChannelComparison &channel)
{
    if (channel.count == 0 || channel.missingModel > 0 || channel.worstOver > kBoundsOfCloseness ||
        channel.excess > kExcessOfCloseness) {
        return Verdict::Differs;
    }
    const bool mostWithin = 100 * channel.withinBound >= kPercentWithinBound * channel.count;
    const bool noneFar = channel.worstOver <= kBoundsOfAgreement && channel.excess <= kExcessOfAgreement;
    return mostWithin && noneFar ? Verdict::Agrees : Verdict::Close;
}

/// Updates the largest error and percentage with the error of one value.
void measure(ChannelComparison &result, double time, double error, double magnitude, bool isZero)
{
    if (!result.maxAbs || error > *result.maxAbs) {
        result.maxAbs = error;
        result.timeOfMaxAbs = time;
    }
    const double percent = isZero ? kNone : error / magnitude * 100.0;
    if (!std::isfinite(percent)) {
        ++result.zeroReference;
    } else if (!result.maxPercent || percent > *result.maxPercent) {
        result.maxPercent = percent;
        result.timeOfMaxPercent = time;
    }
}

/// `effect`: null if the time stamps are exact.
ChannelComparison compareColumn(const Column &column, const Scale &scale, const RoundedTimeEffect *effect)
{
    const Channel channel = column.reference.channel;
    ChannelComparison result;
    result.channel = channel;
    result.peak = scale.peak;
    const double unit = scale.size > 0.0 ? scale.size : 1.0; // in this unit no square overflows or underflows
    double squares = 0.0;
    double largestStep = 0.0;
    for (std::size_t i = 0; i < column.time.size(); ++i) {
        const double value = column.reference.values[i];
        const double model = column.model[i];
        if (!std::isfinite(value)) {
            continue;
        }
        const double step = column.reference.rounding.stepAt(value);
        largestStep = std::max(largestStep, step);
        if (!std::isfinite(model)) {
            result.missingModel += effect != nullptr && effect->isMotionPossible(channel, i) ? 0 : 1;
            continue;
        }
        ++result.count;
        const double magnitude = std::abs(value);
        const double error = std::abs(model - value);
        const double halfStep = 0.5 * std::max(step, scale.smallestStep);
        squares += (error / unit) * (error / unit);
        measure(result, column.time[i], error, magnitude, magnitude <= halfStep);
        double bound = halfStep + kUlpSlack * magnitude;
        if (effect != nullptr && error > bound) {
            bound += effect->drift(channel, i, model, scale.halfRange);
        }
        result.withinBound += error <= bound ? 1 : 0;
        if (error > bound) {
            result.excess = std::max(result.excess, (error - bound) / scale.halfRange);
        }
        if (error > result.worstOver * bound) {
            result.worstOver = error / bound;
        }
    }
    result.verdict = judge(result);
    if (column.reference.rounding.rule != Rounding::Rule::Unknown && largestStep > 0.0) {
        result.roundingStep = largestStep;
    }
    if (result.count > 0) {
        result.rms = unit * std::sqrt(squares / static_cast<double>(result.count));
        if (scale.peak > 0.0) {
            result.percentOfPeak = *result.maxAbs / scale.peak * 100.0;
        }
    }
    return result;
}

Trajectory exactMotion(const Mechanism &mechanism, std::vector<double> times, const ChannelSet &channels,
                       std::stop_token stop = {})
{
    return sample(mechanism, std::move(times), channels, {.method = Method::ClosedForm, .newton = {}}, std::move(stop));
}

/// The effect of time stamps that were rounded to step(time), in s; nullopt if the crank does not move in that time.
template <class Step>
std::optional<RoundedTimeEffect> effectOfRoundedTime(const Mechanism &mechanism, const ReferenceData &reference,
                                                     const Step &step)
{
    std::vector<double> early = reference.time;
    std::vector<double> late = reference.time;
    double largest = 0.0;
    for (std::size_t i = 0; i < reference.time.size(); ++i) {
        const double half = 0.5 * std::max(step(reference.time[i]), kUlpSlack * std::abs(reference.time[i]));
        early[i] -= half;
        late[i] += half;
        largest = std::max(largest, half);
    }
    if (!(2.0 * largest * std::abs(mechanism.omega2()) > kArithmeticStep)) {
        return std::nullopt;
    }
    const ChannelSet channels = channelsOf(reference);
    return RoundedTimeEffect{exactMotion(mechanism, std::move(early), channels),
                             exactMotion(mechanism, std::move(late), channels)};
}

} // namespace

ChannelSize sizeOf(const Mechanism &mechanism, Channel channel)
{
    ChannelSize size;
    size.natural = toFileUnit(channel, naturalSize(mechanism.parameters(), channel));
    const Coordinate coordinate = channel.coordinate;
    const bool belongsToGround = coordinate == R1x || coordinate == R1y || coordinate == Theta1;
    const bool belongsToLine = coordinate == R4y || coordinate == Theta4;
    const bool belongsToDrive = coordinate == Theta2 && channel.order != Order::Position;
    if (belongsToGround || belongsToLine || belongsToDrive) {
        const double position = toFileUnit(channel, isAngle(coordinate) ? 1.0 : mechanism.a());
        size.still = position * std::pow(std::abs(mechanism.omega2()), static_cast<int>(channel.order));
    } else if (coordinate == Theta2) {
        size.most = toFileUnit(channel, std::numbers::pi);
    }
    return size;
}

ChannelComparison compareChannel(std::span<const double> time, std::span<const double> model,
                                 const ReferenceSeries &reference, const ChannelSize &size)
{
    assert(model.size() == time.size() && reference.values.size() == time.size());
    const Column column{time, model, reference};
    return compareColumn(column, scaleOf(column, size), nullptr);
}

std::vector<ChannelComparison> compare(const Mechanism &mechanism, const Trajectory &model,
                                       const ReferenceData &reference)
{
    const Clock clock = clockOf(reference);
    const auto roundedStep = [&](double time) { return reference.timeRounding.stepAt(time); };
    const std::optional<RoundedTimeEffect> effect =
        effectOfRoundedTime(mechanism, reference, [&](double time) { return clock.rounded ? roundedStep(time) : 0.0; });
    std::vector<Scale> scales(reference.series.size());
    std::vector<ChannelComparison> result(reference.series.size());
    const auto columnAt = [&](std::size_t i) {
        return Column{reference.time, model[reference.series[i].channel], reference.series[i]};
    };
    const bool isLong = reference.time.size() > kFewestForThreads;
    const auto compareSeries = [&](std::size_t i) {
        scales[i] = scaleOf(columnAt(i), sizeOf(mechanism, reference.series[i].channel));
        result[i] = compareColumn(columnAt(i), scales[i], effect ? &*effect : nullptr);
    };
    inParallel(result.size(), compareSeries, isLong);

    // Time stamps that do not show it may nevertheless have been rounded. The effect must be small compared with the
    // motion, and with evenly spaced time stamps the best verdict is `close`.
    const auto mayRise = [&](const ChannelComparison &channel) {
        return channel.verdict == Verdict::Differs || (channel.verdict == Verdict::Close && !clock.even);
    };
    if (clock.rounded || std::ranges::none_of(result, mayRise)) {
        return result;
    }
    std::optional<RoundedTimeEffect> possible = effectOfRoundedTime(
        mechanism, reference, [&](double time) { return clock.even ? clock.printedStep : roundedStep(time); });
    if (!possible) {
        return result;
    }
    possible->largestDrift = kExcessOfCloseness;
    const auto compareAgain = [&](std::size_t i) {
        if (!mayRise(result[i])) {
            return;
        }
        ChannelComparison again = compareColumn(columnAt(i), scales[i], &*possible);
        if (again.verdict != Verdict::Differs) {
            again.clockIsRounded = clock.even;
            again.verdict = clock.even ? Verdict::Close : again.verdict;
            result[i] = again;
        }
    };
    inParallel(result.size(), compareAgain, isLong);
    return result;
}

ExactComparison compareExactly(const Mechanism &mechanism, const ReferenceData &reference, std::stop_token stop)
{
    Trajectory model = exactMotion(mechanism, reference.time, channelsOf(reference), std::move(stop));
    ExactComparison result{compare(mechanism, model, reference), {}};
    result.status = std::move(model.status);
    return result;
}

MotionDifference differenceOf(const Mechanism &mechanism, const Mechanism &other, double from, double to)
{
    constexpr int kSteps = 2000;
    double duration = std::abs(to - from);
    if (mechanism.omega2() == other.omega2() && mechanism.omega2() != 0.0) {
        duration = std::min(duration, kTurn / std::abs(mechanism.omega2())); // all turns are equal
    }
    const std::vector<double> times = Sampling{std::min(from, to), duration, kSteps}.timeStamps();
    const Trajectory model = exactMotion(mechanism, times, plottedChannels());
    Trajectory pinned = exactMotion(other, times, plottedChannels());
    MotionDifference difference;
    for (const Channel channel : kPlottedChannels) {
        const ReferenceSeries series{channel, std::move(pinned.values[indexOf(channel)]), Rounding()};
        const ChannelComparison comparison = compareChannel(times, model[channel], series, sizeOf(mechanism, channel));
        difference.hasGaps =
            difference.hasGaps || (channel.order == Order::Position && comparison.count < times.size());
        difference.channels.push_back(comparison);
    }
    return difference;
}

} // namespace slidercrank
