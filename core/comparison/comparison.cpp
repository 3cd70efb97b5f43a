// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/comparison/comparison.h"

#include "core/import/clock.h"
#include "core/mechanism/in_parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace slidercrank
{

namespace
{

/// Decimal numbers are not exact in binary: a value off by exactly half a step may look off by so many units in its
/// last place more.
constexpr double kUlpSlack = 4.0;

Verdict verdictOf(const ChannelComparison &channel)
{
    if (channel.count == 0 || channel.missingModel > 0 || channel.worstOver > kBoundsOfCloseness ||
        channel.excess > kExcessOfCloseness) {
        return Verdict::Differs;
    }
    const bool mostWithin = 100 * channel.withinBound >= kPercentWithinBound * channel.count;
    const bool noneFar = channel.worstOver <= kBoundsOfAgreement && channel.excess <= kExcessOfAgreement;
    return mostWithin && noneFar ? Verdict::Agrees : Verdict::Close;
}

/// Instants that are compared together: few enough to stay in the processor's cache. Sums are taken block by block, so
/// that they come out the same however many threads take part.
constexpr std::size_t kBlock = 4096;

/// What a channel's errors are measured by.
struct Measure {
    const ReferenceSeries &reference;
    ChannelSize size;
    double peak = 0.0;         ///< of the reference
    double smallestStep = 0.0; ///< of its rounding
    double unit = 1.0;         ///< a power of two of about the size of the numbers: in it no square over- or underflows

    /// What the doubt about an instant may add to a bound.
    double mostDrift = std::numeric_limits<double>::infinity();

    /// The bound of an error where the instant is exact. `step`: of the file, at that value.
    double boundOf(double value, double step) const
    {
        return 0.5 * std::max(step, smallestStep) +
               kUlpSlack * std::numeric_limits<double>::epsilon() * std::abs(value);
    }
};

Measure measureOf(const ReferenceSeries &reference, const ChannelSize &channelSize)
{
    double peak = 0.0;
    for (const double value : reference.values) {
        const double magnitude = std::abs(value);
        peak = magnitude > peak && magnitude <= std::numeric_limits<double>::max() ? magnitude : peak;
    }
    const double size = std::max(peak, channelSize.natural);
    constexpr int kMostPowers = 1000; // of two, that still have an inverse
    const double unit = size > 0.0 ? std::ldexp(1.0, std::clamp(std::ilogb(size), -kMostPowers, kMostPowers)) : 1.0;
    const double smallestStep =
        std::max(kArithmeticStep * size, kSmallestPartOfLargestStep * reference.rounding.stepAt(peak));
    return {reference, channelSize, peak, smallestStep, unit};
}

/// What was seen at some instants in a row.
struct Seen {
    std::size_t count = 0;
    std::size_t missingModel = 0;
    std::size_t zeroReference = 0;
    std::size_t withinBound = 0;
    double maxAbs = -1.0;
    double timeOfMaxAbs = 0.0;
    double maxPercent = -1.0;
    double timeOfMaxPercent = 0.0;
    double largestStep = 0.0;
    double worstOver = 0.0;
    double farthestBeyond = 0.0; ///< its bound
    double squares = 0.0;        ///< of the errors, in units
    ValueRange model{};
};

/// One channel at some instants in a row, as the file and the model have it.
struct Stretch {
    std::span<const double> time;
    std::span<const double> model;
    std::span<const double> values;
};

/// What an error of `error` within or beyond `bound` adds.
void judge(double error, double bound, Seen &seen)
{
    if (error <= bound) {
        ++seen.withinBound;
    } else {
        seen.farthestBeyond = std::max(seen.farthestBeyond, error - bound);
    }
    if (error > seen.worstOver * bound) {
        seen.worstOver = error / bound;
    }
}

/// `beyond`: where the rows go that are not within the bound of an exact instant, or have no model, to be judged with
/// their doubt; null where they have none.
Seen seenIn(const Stretch &stretch, const Measure &measure, std::vector<std::size_t> *beyond)
{
    Seen seen;
    RoundingSteps steps(measure.reference.rounding);
    const double inUnits = 1.0 / measure.unit;
    for (std::size_t i = 0; i < stretch.time.size(); ++i) {
        const double value = stretch.values[i];
        if (!std::isfinite(value)) {
            continue;
        }
        const double stepOfFile = steps.at(value);
        seen.largestStep = std::max(seen.largestStep, stepOfFile);
        const double model = stretch.model[i];
        if (!std::isfinite(model)) {
            if (beyond) {
                beyond->push_back(i);
            } else {
                ++seen.missingModel;
            }
            continue;
        }
        ++seen.count;
        seen.model.low = std::min(seen.model.low, model);
        seen.model.high = std::max(seen.model.high, model);
        const double magnitude = std::abs(value);
        const double error = std::abs(model - value);
        seen.squares += (error * inUnits) * (error * inUnits);
        if (error > seen.maxAbs) {
            seen.maxAbs = error;
            seen.timeOfMaxAbs = stretch.time[i];
        }
        // Quotients only where they can be the largest.
        if (!(error * 100.0 <= seen.maxPercent * magnitude) || value == 0.0) {
            const double percent = value == 0.0 ? std::numeric_limits<double>::infinity() : error / magnitude * 100.0;
            if (!std::isfinite(percent)) {
                ++seen.zeroReference;
            } else if (percent > seen.maxPercent) {
                seen.maxPercent = percent;
                seen.timeOfMaxPercent = stretch.time[i];
            }
        }
        const double bound = measure.boundOf(value, stepOfFile);
        if (beyond && !(error <= bound)) {
            beyond->push_back(i);
        } else {
            judge(error, bound, seen);
        }
    }
    return seen;
}

/// The motion at the ends of what some instants may have been before they were rounded.
struct Sides {
    Trajectory early;
    Trajectory late;
};

/// How far the motion goes from `model` to the sides: without bound where it ends in between.
double driftFrom(double model, double early, double late)
{
    return std::isfinite(early) && std::isfinite(late) ? std::max(std::abs(early - model), std::abs(late - model))
                                                       : std::numeric_limits<double>::infinity();
}

/// Judges the rows that were left. `placeOf`: where each of them is in `sides`.
void judgeBeyond(const Stretch &stretch, const Measure &measure, std::span<const std::size_t> beyond,
                 const Sides &sides, std::span<const std::size_t> placeOf, Seen &seen)
{
    RoundingSteps steps(measure.reference.rounding);
    const Channel channel = measure.reference.channel;
    for (const std::size_t row : beyond) {
        const double value = stretch.values[row];
        const double model = stretch.model[row];
        const double early = sides.early[channel][placeOf[row]];
        const double late = sides.late[channel][placeOf[row]];
        if (std::isfinite(model)) {
            const double drift = std::min(driftFrom(model, early, late), measure.mostDrift);
            judge(std::abs(model - value), measure.boundOf(value, steps.at(value)) + drift, seen);
        } else if (!std::isfinite(early) && !std::isfinite(late)) {
            ++seen.missingModel; // else the instant itself may have been one where the model is
        }
    }
}

/// As if `later` had been seen after it.
void add(Seen &seen, const Seen &later)
{
    seen.count += later.count;
    seen.missingModel += later.missingModel;
    seen.zeroReference += later.zeroReference;
    seen.withinBound += later.withinBound;
    if (later.maxAbs > seen.maxAbs) {
        seen.maxAbs = later.maxAbs;
        seen.timeOfMaxAbs = later.timeOfMaxAbs;
    }
    if (later.maxPercent > seen.maxPercent) {
        seen.maxPercent = later.maxPercent;
        seen.timeOfMaxPercent = later.timeOfMaxPercent;
    }
    seen.largestStep = std::max(seen.largestStep, later.largestStep);
    seen.worstOver = std::max(seen.worstOver, later.worstOver);
    seen.farthestBeyond = std::max(seen.farthestBeyond, later.farthestBeyond);
    seen.squares += later.squares;
    seen.model.low = std::min(seen.model.low, later.model.low);
    seen.model.high = std::max(seen.model.high, later.model.high);
}

double halfRangeOf(const Seen &seen, const Measure &measure)
{
    const ChannelSize &size = measure.size;
    return size.still > 0.0 ? size.still : std::min(0.5 * seen.model.high - 0.5 * seen.model.low, size.most);
}

ChannelComparison comparisonOf(const Seen &seen, const Measure &measure)
{
    ChannelComparison result;
    result.channel = measure.reference.channel;
    result.count = seen.count;
    result.missingModel = seen.missingModel;
    result.zeroReference = seen.zeroReference;
    result.withinBound = seen.withinBound;
    result.worstOver = seen.worstOver;
    if (seen.farthestBeyond > 0.0) {
        result.excess = seen.farthestBeyond / halfRangeOf(seen, measure);
    }
    result.verdict = verdictOf(result);
    if (measure.reference.rounding.rule != Rounding::Rule::Unknown && seen.largestStep > 0.0) {
        result.roundingStep = seen.largestStep;
    }
    if (seen.maxPercent >= 0.0) {
        result.maxPercent = seen.maxPercent;
        result.timeOfMaxPercent = seen.timeOfMaxPercent;
    }
    if (seen.count > 0) {
        result.maxAbs = seen.maxAbs;
        result.timeOfMaxAbs = seen.timeOfMaxAbs;
        result.rms = measure.unit * std::sqrt(seen.squares / static_cast<double>(seen.count));
        if (measure.peak > 0.0) {
            result.percentOfPeak = seen.maxAbs / measure.peak * 100.0;
        }
    }
    return result;
}

constexpr std::size_t kWorthAThread = 50000; // instants

SolverSettings exactly()
{
    SolverSettings settings;
    settings.method = Method::ClosedForm;
    return settings;
}

ChannelSet channelsOf(std::span<const Measure> measures)
{
    ChannelSet channels;
    for (const Measure &measure : measures) {
        channels.set(indexOf(measure.reference.channel));
    }
    return channels;
}

/// What the instants of a file may be off by.
struct Doubt {
    const Rounding *rounding = nullptr; ///< of the instants, where they show it
    double step = 0.0;                  ///< s, else

    double stepAt(double time) const
    {
        const double ofADouble = kUlpSlack * std::numeric_limits<double>::epsilon() * std::abs(time);
        return std::max(rounding ? rounding->stepAt(time) : step, ofADouble);
    }

    /// Whether the crank has turned by anything in that time.
    bool matters(const Mechanism &mechanism, std::span<const double> time) const
    {
        const double latest = time.empty() ? 0.0 : std::max(std::abs(time.front()), std::abs(time.back()));
        return std::abs(mechanism.omega2()) * stepAt(latest) > kArithmeticStep;
    }
};

/// At the rows of a stretch that one of the channels wants; `placeOf` tells where each row's went.
Sides sidesOf(const Mechanism &mechanism, const ChannelSet &channels, std::span<const double> time, const Doubt &doubt,
              std::span<const std::vector<std::size_t>> beyond, std::vector<std::size_t> &placeOf)
{
    std::vector<char> isWanted(time.size());
    for (const std::vector<std::size_t> &rows : beyond) {
        for (const std::size_t row : rows) {
            isWanted[row] = 1;
        }
    }
    placeOf.resize(time.size());
    std::vector<double> early;
    std::vector<double> late;
    for (std::size_t row = 0; row < time.size(); ++row) {
        if (isWanted[row]) {
            const double half = 0.5 * doubt.stepAt(time[row]);
            placeOf[row] = early.size();
            early.push_back(time[row] - half);
            late.push_back(time[row] + half);
        }
    }
    return {sample(mechanism, std::move(early), channels, exactly()),
            sample(mechanism, std::move(late), channels, exactly())};
}

/// The series of some measures against a motion that is to be had piece by piece: `withModel`(from, count, use) calls
/// use(trajectory, place of the first instant in it).
template <typename WithModel>
std::vector<Seen> compareBlocks(const Mechanism &mechanism, std::span<const double> time,
                                std::span<const Measure> measures, const Doubt &doubt, WithModel withModel)
{
    const std::size_t blocks = (time.size() + kBlock - 1) / kBlock;
    std::vector<Seen> seen(blocks * measures.size()); // by block, then by series
    const bool inDoubt = doubt.matters(mechanism, time);
    const ChannelSet channels = channelsOf(measures);
    const auto compareBlock = [&](std::size_t block) {
        const std::size_t from = block * kBlock;
        const std::size_t count = std::min(kBlock, time.size() - from);
        withModel(from, count, [&](const Trajectory &model, std::size_t place) {
            const auto stretchOf = [&](const ReferenceSeries &series) {
                return Stretch{time.subspan(from, count), std::span(model[series.channel]).subspan(place, count),
                               std::span(series.values).subspan(from, count)};
            };
            Seen *const seenHere = &seen[block * measures.size()];
            std::vector<std::vector<std::size_t>> beyond(measures.size());
            for (std::size_t i = 0; i < measures.size(); ++i) {
                seenHere[i] = seenIn(stretchOf(measures[i].reference), measures[i], inDoubt ? &beyond[i] : nullptr);
            }
            if (std::ranges::all_of(beyond, &std::vector<std::size_t>::empty)) {
                return;
            }
            std::vector<std::size_t> placeOf;
            const Sides sides = sidesOf(mechanism, channels, time.subspan(from, count), doubt, beyond, placeOf);
            for (std::size_t i = 0; i < measures.size(); ++i) {
                judgeBeyond(stretchOf(measures[i].reference), measures[i], beyond[i], sides, placeOf, seenHere[i]);
            }
        });
    };
    inParallel(blocks, compareBlock, time.size() > kWorthAThread);
    std::vector<Seen> all(measures.size());
    for (std::size_t block = 0; block < blocks; ++block) {
        for (std::size_t i = 0; i < measures.size(); ++i) {
            add(all[i], seen[block * measures.size() + i]);
        }
    }
    return all;
}

/// Whether a series may come close if its instants are in doubt: not where the largest error alone is too much for it.
bool mayComeClose(const Mechanism &mechanism, const Measure &measure, const Seen &seen, const Doubt &doubt)
{
    const Channel channel = measure.reference.channel;
    ChannelSet channels;
    channels.set(indexOf(channel));
    const double half = 0.5 * doubt.stepAt(seen.timeOfMaxAbs);
    const Trajectory motion =
        sample(mechanism, {seen.timeOfMaxAbs - half, seen.timeOfMaxAbs, seen.timeOfMaxAbs + half}, channels, exactly());
    const std::vector<double> &f = motion[channel];
    const double drift = std::min(driftFrom(f[1], f[0], f[2]), measure.mostDrift);
    const double bound = measure.boundOf(measure.peak, seen.largestStep) + drift;
    return seen.count > 0 && !(seen.maxAbs - bound > kExcessOfCloseness * halfRangeOf(seen, measure));
}

template <typename WithModel>
std::vector<ChannelComparison> compareSeries(const Mechanism &mechanism, const ReferenceData &reference,
                                             WithModel withModel)
{
    std::vector<Measure> measures;
    for (const ReferenceSeries &series : reference.series) {
        measures.push_back(measureOf(series, sizeOf(mechanism, series.channel)));
    }
    const Clock clock = clockOf(reference);
    const Doubt rounded{&reference.timeRounding};
    std::vector<Seen> seen =
        compareBlocks(mechanism, reference.time, measures, clock.rounded ? rounded : Doubt{}, withModel);
    std::vector<ChannelComparison> result;
    for (std::size_t i = 0; i < measures.size(); ++i) {
        result.push_back(comparisonOf(seen[i], measures[i]));
    }

    // Instants that may have been rounded: what that adds must be small beside the motion, as what lies beyond must.
    const Doubt doubt = clock.even ? Doubt{nullptr, clock.printedStep} : rounded;
    if (clock.rounded || !doubt.matters(mechanism, reference.time)) {
        return result;
    }
    std::vector<std::size_t> doubted;
    std::vector<Measure> again;
    for (std::size_t i = 0; i < measures.size(); ++i) {
        measures[i].mostDrift = kExcessOfCloseness * halfRangeOf(seen[i], measures[i]);
        const bool mayRise =
            result[i].verdict == Verdict::Differs || (result[i].verdict == Verdict::Close && !clock.even);
        if (mayRise && mayComeClose(mechanism, measures[i], seen[i], doubt)) {
            doubted.push_back(i);
            again.push_back(measures[i]);
        }
    }
    if (again.empty()) {
        return result;
    }
    seen = compareBlocks(mechanism, reference.time, again, doubt, withModel);
    for (std::size_t k = 0; k < again.size(); ++k) {
        ChannelComparison found = comparisonOf(seen[k], again[k]);
        if (found.verdict == Verdict::Differs) {
            continue;
        }
        found.clockIsRounded = clock.even;
        found.verdict = clock.even ? Verdict::Close : found.verdict;
        result[doubted[k]] = found;
    }
    return result;
}

} // namespace

ChannelSize sizeOf(const Mechanism &mechanism, Channel channel)
{
    ChannelSize size;
    size.natural = toFileUnit(channel, naturalSize(mechanism.parameters(), channel));
    const Coordinate coordinate = channel.coordinate;
    const bool ofTheGround = coordinate == R1x || coordinate == R1y || coordinate == Theta1;
    const bool ofTheLine = coordinate == R4y || coordinate == Theta4;
    const bool ofTheDrive = coordinate == Theta2 && channel.order != Order::Position;
    if (ofTheGround || ofTheLine || ofTheDrive) {
        const double reach = isAngle(coordinate) ? kDegreesPerRadian : mechanism.a();
        size.still = reach * std::pow(std::abs(mechanism.omega2()), static_cast<int>(channel.order));
    } else if (coordinate == Theta2) {
        size.most = 180.0;
    }
    return size;
}

ChannelComparison compareChannel(std::span<const double> time, std::span<const double> model,
                                 const ReferenceSeries &reference, const ChannelSize &size)
{
    const std::span<const double> values(reference.values);
    assert(model.size() == time.size() && values.size() == time.size());
    const Measure measure = measureOf(reference, size);
    Seen seen;
    for (std::size_t from = 0; from < time.size(); from += kBlock) {
        const std::size_t count = std::min(kBlock, time.size() - from);
        add(seen, seenIn({time.subspan(from, count), model.subspan(from, count), values.subspan(from, count)}, measure,
                         nullptr));
    }
    return comparisonOf(seen, measure);
}

ExactComparison compareExactly(const Mechanism &mechanism, const ReferenceData &reference, std::stop_token stop)
{
    ExactComparison result;
    result.status.resize(reference.time.size());
    const ChannelSet channels = channelsOf(reference);
    result.channels = compareSeries(mechanism, reference, [&](std::size_t from, std::size_t count, const auto &use) {
        const auto first = reference.time.begin() + static_cast<std::ptrdiff_t>(from);
        const Trajectory model =
            sample(mechanism, {first, first + static_cast<std::ptrdiff_t>(count)}, channels, exactly(), stop);
        std::copy(model.status.begin(), model.status.end(), result.status.begin() + static_cast<std::ptrdiff_t>(from));
        use(model, 0);
    });
    return result;
}

std::vector<ChannelComparison> compare(const Mechanism &mechanism, const Trajectory &model,
                                       const ReferenceData &reference)
{
    return compareSeries(mechanism, reference,
                         [&](std::size_t from, std::size_t, const auto &use) { use(model, from); });
}

} // namespace slidercrank
