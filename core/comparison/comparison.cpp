// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/comparison/comparison.h"

#include "core/import/clock.h"
#include "core/mechanism/in_parallel.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

/// Relative tolerance of a bound. Decimal numbers are not exact in binary: a difference of exactly half a step may
/// appear larger by some units in the last place.
constexpr double kUlpSlack = 4.0 * kEpsilon;

/// rad: a smaller rotation of the crank is lost in the rounding errors of the motion.
constexpr double kNegligibleRotation = 1e-12;

constexpr SolverSettings kClosedFormSettings{.method = Method::ClosedForm, .newton = {}};

constexpr std::size_t kMinTimeStampsForThreads = 50000; // with fewer, threads cost more than they save

/// The sizes with which the errors of a column are compared, in its unit.
struct Scale {
    double peak = 0.0;         ///< largest magnitude of the reference
    double size = 0.0;         ///< the larger of the peak and the channel's natural size
    double smallestStep = 0.0; ///< a smaller rounding step of a value counts as this one
    /// Half the range of the model's motion; for the k-th derivative of a constant channel, a or 1 rad, times |ω2|^k.
    double halfRange = 0.0;
};

/// Returns Scale::halfRange. `model`: the values of the motion, one for each value of the reference; only those where
/// the reference has a value count.
double halfRangeOfMotion(const Mechanism &mechanism, const ReferenceSeries &reference, std::span<const double> model)
{
    const auto [coordinate, order] = reference.channel;
    const bool isOfGround = coordinate == R1x || coordinate == R1y || coordinate == Theta1;
    const bool isFixedInSlider = coordinate == R4y || coordinate == Theta4;
    const bool isSpeedOfCrank = coordinate == Theta2 && order != Order::Position;
    if (isOfGround || isFixedInSlider || isSpeedOfCrank) { // constant
        const double size = isAngle(coordinate) ? 1.0 : mechanism.a();
        return toFileUnit(reference.channel, size) * std::pow(std::abs(mechanism.omega2()), static_cast<int>(order));
    }
    ValueRange range;
    for (std::size_t i = 0; i < model.size(); ++i) {
        if (std::isfinite(reference.values[i])) {
            range.include(model[i]);
        }
    }
    const double halfRange = 0.5 * range.width();
    // Crank angles are compared up to whole turns: in a file of many turns, they range over half a turn to either side.
    return coordinate == Theta2 ? std::min(halfRange, toFileUnit(reference.channel, std::numbers::pi)) : halfRange;
}

Scale scaleOf(const Mechanism &mechanism, const ReferenceSeries &reference, std::span<const double> model)
{
    const Channel channel = reference.channel;
    const double peak = rangeOf(reference.values).size();
    const double size = std::max(peak, toFileUnit(channel, naturalSize(mechanism.parameters(), channel)));
    const double fractionOfLargestStep = kSmallestFractionOfLargestStep * reference.rounding.stepAt(peak);
    return {.peak = peak,
            .size = size,
            .smallestStep = std::max(kArithmeticStep * size, fractionOfLargestStep),
            .halfRange = halfRangeOfMotion(mechanism, reference, model)};
}

/// The effect of rounded time stamps: the exact motion half a rounding step of the time earlier and later.
struct RoundedTimeEffect {
    Trajectory early;
    Trajectory late;
    /// drift() returns at most this fraction of half the range of the motion; nullopt: nothing limits it.
    std::optional<double> largestDrift = {};

    /// Returns whether the mechanism can be assembled within the rounding of the row's time stamp.
    bool isMotionPossible(Channel channel, std::size_t row) const
    {
        return std::isfinite(early[channel][row]) || std::isfinite(late[channel][row]);
    }

    /// Returns by how much the rounding of the row's time stamp may change the value `model`. `halfRange`: half the
    /// range of the motion.
    double drift(Channel channel, std::size_t row, double model, double halfRange) const
    {
        const double change = std::max(std::abs(early[channel][row] - model), std::abs(late[channel][row] - model));
        const bool existsThroughout = std::isfinite(early[channel][row]) && std::isfinite(late[channel][row]);
        const double limit = largestDrift ? *largestDrift * halfRange : kInfinity;
        return existsThroughout ? std::min(change, limit) : limit;
    }
};

Verdict verdictOf(const ChannelComparison &channel)
{
    if (channel.count == 0 || channel.missingModelCount > 0 || channel.largestErrorInBounds > kMaxBoundsToBeClose ||
        channel.excess > kMaxExcessToBeClose) {
        return Verdict::Differs;
    }
    const bool areMostWithinBound = 100 * channel.countWithinBound >= kMinPercentWithinBound * channel.count;
    const bool areAllClose = channel.largestErrorInBounds <= kMaxBoundsToAgree && channel.excess <= kMaxExcessToAgree;
    return areMostWithinBound && areAllClose ? Verdict::Agrees : Verdict::Close;
}

/// Updates the largest error and the largest percentage with the error of one value. `percent`: the error in percent of
/// the value; not finite if it has no meaning.
void updateLargestErrors(ChannelComparison &result, double time, double error, double percent)
{
    if (!result.largestError || error > *result.largestError) {
        result.largestError = error;
        result.timeOfLargestError = time;
    }
    if (!std::isfinite(percent)) {
        ++result.zeroReferenceCount;
    } else if (!result.maxPercent || percent > *result.maxPercent) {
        result.maxPercent = percent;
        result.timeOfMaxPercent = time;
    }
}

/// Updates the measures of the verdict with the error of one value and its bound.
void updateVerdictMeasures(ChannelComparison &result, double error, double bound, double halfRange)
{
    if (error <= bound) {
        ++result.countWithinBound;
    } else {
        result.excess = std::max(result.excess, (error - bound) / halfRange);
    }
    if (error > result.largestErrorInBounds * bound) {
        result.largestErrorInBounds = error / bound;
    }
}

/// Returns the magnitude of the difference of two values, in the unit of the file. Crank angles are compared modulo a
/// turn, because files may count them from zero again after each turn.
double errorOf(Channel channel, double model, double value)
{
    constexpr double kDegreesPerTurn = 360.0;
    const bool isCrankAngle = channel == Channel{Theta2, Order::Position};
    return std::abs(isCrankAngle ? std::remainder(model - value, kDegreesPerTurn) : model - value);
}

/// Returns the root-mean-square error of a column over the rows in which both values exist; nullopt if there are none.
/// `size`: that of the values, relative to which no square overflows or underflows.
std::optional<double> rmsError(const ReferenceSeries &series, std::span<const double> models, double size)
{
    const double unit = size > 0.0 ? size : 1.0;
    double squares = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < models.size(); ++i) {
        const double error = errorOf(series.channel, models[i], series.values[i]);
        if (std::isfinite(error)) {
            squares += (error / unit) * (error / unit);
            ++count;
        }
    }
    return count > 0 ? std::optional(unit * std::sqrt(squares / static_cast<double>(count))) : std::nullopt;
}

/// The model with which the columns of a file are compared.
struct ComparedModel {
    const Mechanism &mechanism;
    const Trajectory &trajectory; ///< its motion at the time stamps of the file
    FittedMechanism fitted{};
};

/// Returns half the rounding step of a value.
double halfStepOf(const ReferenceSeries &series, std::size_t row, const Scale &scale)
{
    return 0.5 * std::max(series.rounding.stepAt(series.values[row]), scale.smallestStep);
}

/// Returns the largest bound that rounding gives an error in the column. `models`: the motion in each row. `effect`:
/// null if the time stamps are exact.
double largestRoundingBound(const ReferenceSeries &series, std::span<const double> models, const Scale &scale,
                            const RoundedTimeEffect *effect)
{
    const double largestHalfStep = 0.5 * std::max(series.rounding.stepAt(scale.peak), scale.smallestStep);
    double largestDrift = 0.0;
    for (std::size_t i = 0; effect != nullptr && i < models.size(); ++i) {
        const double drift = effect->drift(series.channel, i, models[i], scale.halfRange);
        if (std::isfinite(series.values[i]) && std::isfinite(drift)) {
            largestDrift = std::max(largestDrift, drift);
        }
    }
    return largestHalfStep + kUlpSlack * scale.peak + largestDrift;
}

/// Returns by how much the bounds of the column increase because the mechanism was fitted (FittedMechanism). `rms`:
/// that of the errors of the column. `effect`: null if the time stamps are exact.
double fitErrorIn(const ComparedModel &compared, const ReferenceSeries &series, double rms, const Scale &scale,
                  const RoundedTimeEffect *effect)
{
    if (compared.fitted.unknowns == 0) {
        return 0.0;
    }
    return std::min(compared.fitted.errorOf(rms),
                    largestRoundingBound(series, compared.trajectory[series.channel], scale, effect));
}

/// Compares the column `series` of the reference. `effect`: null if the time stamps are exact.
ChannelComparison compareSeries(const ComparedModel &compared, const ReferenceData &reference,
                                const ReferenceSeries &series, const RoundedTimeEffect *effect)
{
    const Channel channel = series.channel;
    const std::vector<double> &models = compared.trajectory[channel];
    assert(models.size() == reference.time.size() && series.values.size() == models.size());
    const Scale scale = scaleOf(compared.mechanism, series, models);
    ChannelComparison result;
    result.channel = channel;
    result.peak = scale.peak;
    result.rms = rmsError(series, models, scale.size);
    const double fitError = fitErrorIn(compared, series, result.rms.value_or(0.0), scale, effect);
    double largestStep = 0.0;
    for (std::size_t i = 0; i < models.size(); ++i) {
        const double value = series.values[i];
        const double model = models[i];
        if (!std::isfinite(value)) {
            continue;
        }
        largestStep = std::max(largestStep, series.rounding.stepAt(value));
        if (!std::isfinite(model)) {
            const bool isExplained = effect != nullptr && effect->isMotionPossible(channel, i);
            result.missingModelCount += isExplained ? 0 : 1;
            continue;
        }
        ++result.count;
        const double magnitude = std::abs(value);
        const double error = errorOf(channel, model, value);
        const double halfStep = halfStepOf(series, i, scale);
        const bool isZeroExceptForRounding = magnitude <= halfStep;
        const double percent = isZeroExceptForRounding ? kNone : error / magnitude * 100.0;
        updateLargestErrors(result, reference.time[i], error, percent);
        double bound = halfStep + kUlpSlack * magnitude;
        if (effect != nullptr && error > bound) {
            bound += effect->drift(channel, i, model, scale.halfRange);
        }
        bound += fitError;
        updateVerdictMeasures(result, error, bound, scale.halfRange);
    }
    result.verdict = verdictOf(result);
    if (series.rounding.rule != Rounding::Rule::Unknown && largestStep > 0.0) {
        result.roundingStep = largestStep;
    }
    if (result.count > 0 && scale.peak > 0.0) {
        result.percentOfPeak = *result.largestError / scale.peak * 100.0;
    }
    return result;
}

/// Returns the exact motion half a rounding step before and after each time stamp. The step is that of the file if
/// `clock.isRoundedGrid`, otherwise the rounding of a double. Returns nullopt if the crank turns by at most
/// kNegligibleRotation in one step.
std::optional<RoundedTimeEffect> effectOfRoundedTime(const Mechanism &mechanism, const ReferenceData &reference,
                                                     const TimePrecision &clock)
{
    std::vector<double> early = reference.time;
    std::vector<double> late = reference.time;
    double largest = 0.0;
    for (std::size_t i = 0; i < reference.time.size(); ++i) {
        const double time = reference.time[i];
        const double step = clock.isEven ? clock.printedStep : reference.timeRounding.stepAt(time);
        const double half = 0.5 * std::max(clock.isRoundedGrid ? step : 0.0, kUlpSlack * std::abs(time));
        early[i] -= half;
        late[i] += half;
        largest = std::max(largest, half);
    }
    if (!(2.0 * largest * std::abs(mechanism.omega2()) > kNegligibleRotation)) {
        return std::nullopt;
    }
    const ChannelSet channels = channelsOf(reference);
    return RoundedTimeEffect{sample(mechanism, std::move(early), channels, kClosedFormSettings),
                             sample(mechanism, std::move(late), channels, kClosedFormSettings)};
}

/// Calls `function` with the index of each column of the reference; in several threads if the columns are long.
template <class Function>
void forEachSeries(const ReferenceData &reference, const Function &function)
{
    const bool areLong = reference.time.size() > kMinTimeStampsForThreads;
    inParallel(reference.series.size(), function, areLong ? Threads::OnePerProcessor : Threads::CallingThread);
}

/// Compares again the columns that differ and, with uneven time stamps, those that are close, assuming that the time
/// stamps were rounded, although the clock does not show it. Keeps the new comparisons that do not differ. If the time
/// stamps are evenly spaced, the best new verdict is `Close`. `clock`: that of the reference. `compared`, `reference`:
/// those of `channels`.
void compareWithRoundedClock(std::vector<ChannelComparison> &channels, TimePrecision clock,
                             const ComparedModel &compared, const ReferenceData &reference)
{
    const auto canImprove = [&](const ChannelComparison &channel) {
        // Rounded time stamps lower the excess by at most kMaxExcessToBeClose, and a close column may still have an
        // excess of kMaxExcessToBeClose: with more than twice that, the verdict remains Differs.
        const bool isTooFarOff = channel.excess > 2.0 * kMaxExcessToBeClose;
        return !isTooFarOff &&
               (channel.verdict == Verdict::Differs || (channel.verdict == Verdict::Close && !clock.isEven));
    };
    if (clock.isRoundedGrid || std::ranges::none_of(channels, canImprove)) {
        return;
    }
    clock.isRoundedGrid = true;
    std::optional<RoundedTimeEffect> effect = effectOfRoundedTime(compared.mechanism, reference, clock);
    if (!effect) {
        return;
    }
    effect->largestDrift = kMaxExcessToBeClose;
    forEachSeries(reference, [&](std::size_t i) {
        if (!canImprove(channels[i])) {
            return;
        }
        const ChannelComparison withRoundedTime = compareSeries(compared, reference, reference.series[i], &*effect);
        if (withRoundedTime.verdict != Verdict::Differs) {
            channels[i] = withRoundedTime;
            channels[i].clockIsRounded = clock.isEven;
            channels[i].verdict = clock.isEven ? Verdict::Close : withRoundedTime.verdict;
        }
    });
}

} // namespace

std::vector<ChannelComparison> compare(const Mechanism &mechanism, const Trajectory &model,
                                       const ReferenceData &reference, const FittedMechanism &fitted)
{
    const TimePrecision clock = timePrecisionOf(reference.time, reference.timeRounding);
    const ComparedModel compared{mechanism, model, fitted};
    const std::optional<RoundedTimeEffect> effect = effectOfRoundedTime(mechanism, reference, clock);
    std::vector<ChannelComparison> channels(reference.series.size());
    forEachSeries(reference, [&](std::size_t i) {
        channels[i] = compareSeries(compared, reference, reference.series[i], effect ? &*effect : nullptr);
    });
    compareWithRoundedClock(channels, clock, compared, reference);
    return channels;
}

void findRoundedTime(std::vector<ChannelComparison> &channels, const Mechanism &mechanism, const Trajectory &model,
                     const ReferenceData &reference)
{
    const auto differs = [](const ChannelComparison &channel) { return channel.verdict == Verdict::Differs; };
    TimePrecision clock = timePrecisionOf(reference.time, reference.timeRounding);
    if (clock.isEven || clock.isRoundedGrid || std::ranges::none_of(channels, differs)) {
        return;
    }
    clock.isRoundedGrid = true;
    const std::optional<RoundedTimeEffect> effect = effectOfRoundedTime(mechanism, reference, clock);
    for (std::size_t i = 0; effect && i < channels.size(); ++i) {
        if (differs(channels[i])) {
            const ChannelComparison assumed =
                compareSeries({mechanism, model}, reference, reference.series[i], &*effect);
            channels[i].isWithinRoundedTime = assumed.verdict == Verdict::Agrees;
        }
    }
}

ExactComparison compareExactly(const Mechanism &mechanism, const ReferenceData &reference, std::stop_token stop,
                               const FittedMechanism &fitted)
{
    Trajectory model = sample(mechanism, reference.time, channelsOf(reference), kClosedFormSettings, std::move(stop));
    return {compare(mechanism, model, reference, fitted), std::move(model.status)};
}

MotionDifference differenceOf(const Mechanism &mechanism, const Mechanism &reference, double from, double to)
{
    constexpr int kSteps = 2000;
    double duration = std::abs(to - from);
    if (mechanism.omega2() == reference.omega2() && mechanism.omega2() != 0.0) {
        duration = std::min(duration, kTurn / std::abs(mechanism.omega2())); // all turns are equal
    }
    const Sampling sampling{.start = std::min(from, to), .duration = duration, .steps = kSteps};
    ReferenceData referenceMotion;
    referenceMotion.time = sampling.timeStamps();
    Trajectory motion = sample(reference, referenceMotion.time, plottedChannels(), kClosedFormSettings);
    for (const Channel channel : kPlottedChannels) {
        referenceMotion.series.push_back(
            {.channel = channel, .values = std::move(motion.values[indexOf(channel)]), .rounding = Rounding()});
    }
    MotionDifference difference{compareExactly(mechanism, referenceMotion).channels};
    difference.hasGaps = std::ranges::any_of(difference.channels, [&](const ChannelComparison &channel) {
        return channel.channel.order == Order::Position && channel.count < referenceMotion.time.size();
    });
    return difference;
}

} // namespace slidercrank
