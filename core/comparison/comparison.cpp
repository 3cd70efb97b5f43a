// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/comparison/comparison.h"

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
    if (channel.count == 0 || channel.missingModel > 0 || channel.worstHalfSteps > kHalfStepsOfCloseness) {
        return Verdict::Differs;
    }
    const bool mostWithin = 100 * channel.withinHalfStep >= kPercentWithinHalfStep * channel.count;
    return mostWithin && channel.worstHalfSteps <= kHalfStepsOfAgreement ? Verdict::Agrees : Verdict::Close;
}

/// Instants that are compared together: few enough to stay in the processor's cache. Sums are taken block by block, so
/// that they come out the same however many threads take part.
constexpr std::size_t kBlock = 4096;

/// What a channel's errors are measured by.
struct Measure {
    const ReferenceSeries &reference;
    double peak = 0.0;         ///< of the reference
    double smallestStep = 0.0; ///< of its rounding
    double unit = 1.0;         ///< a power of two of about the size of the numbers: in it no square over- or underflows
};

Measure measureOf(const ReferenceSeries &reference, double scale)
{
    double peak = 0.0;
    for (const double value : reference.values) {
        const double magnitude = std::abs(value);
        peak = magnitude > peak && magnitude <= std::numeric_limits<double>::max() ? magnitude : peak;
    }
    const double size = std::max(peak, scale);
    constexpr int kMostPowers = 1000; // of two, that still have an inverse
    const double unit = size > 0.0 ? std::ldexp(1.0, std::clamp(std::ilogb(size), -kMostPowers, kMostPowers)) : 1.0;
    return {reference, peak, kArithmeticStep * size, unit};
}

/// What was seen at some instants in a row.
struct Seen {
    std::size_t count = 0;
    std::size_t missingModel = 0;
    std::size_t zeroReference = 0;
    std::size_t withinHalfStep = 0;
    double maxAbs = -1.0;
    double timeOfMaxAbs = 0.0;
    double maxPercent = -1.0;
    double timeOfMaxPercent = 0.0;
    double largestStep = 0.0;
    double worstHalfSteps = 0.0;
    double squares = 0.0; ///< of the errors, in units
};

Seen seenIn(std::span<const double> time, std::span<const double> model, std::span<const double> values,
            const Measure &measure)
{
    Seen seen;
    RoundingSteps steps(measure.reference.rounding);
    const double inUnits = 1.0 / measure.unit;
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double value = values[i];
        if (!std::isfinite(value)) {
            continue;
        }
        const double stepOfFile = steps.at(value);
        seen.largestStep = std::max(seen.largestStep, stepOfFile);
        if (!std::isfinite(model[i])) {
            ++seen.missingModel;
            continue;
        }
        ++seen.count;
        const double magnitude = std::abs(value);
        const double error = std::abs(model[i] - value);
        seen.squares += (error * inUnits) * (error * inUnits);
        if (error > seen.maxAbs) {
            seen.maxAbs = error;
            seen.timeOfMaxAbs = time[i];
        }
        // Quotients only where they can be the largest.
        if (!(error * 100.0 <= seen.maxPercent * magnitude) || value == 0.0) {
            const double percent = value == 0.0 ? std::numeric_limits<double>::infinity() : error / magnitude * 100.0;
            if (!std::isfinite(percent)) {
                ++seen.zeroReference;
            } else if (percent > seen.maxPercent) {
                seen.maxPercent = percent;
                seen.timeOfMaxPercent = time[i];
            }
        }
        const double step = std::max(stepOfFile, measure.smallestStep);
        const double half = 0.5 * step + kUlpSlack * std::numeric_limits<double>::epsilon() * magnitude;
        if (error <= half) {
            ++seen.withinHalfStep;
        }
        if (error > seen.worstHalfSteps * half) {
            seen.worstHalfSteps = error / half;
        }
    }
    return seen;
}

/// As if `later` had been seen after it.
void add(Seen &seen, const Seen &later)
{
    seen.count += later.count;
    seen.missingModel += later.missingModel;
    seen.zeroReference += later.zeroReference;
    seen.withinHalfStep += later.withinHalfStep;
    if (later.maxAbs > seen.maxAbs) {
        seen.maxAbs = later.maxAbs;
        seen.timeOfMaxAbs = later.timeOfMaxAbs;
    }
    if (later.maxPercent > seen.maxPercent) {
        seen.maxPercent = later.maxPercent;
        seen.timeOfMaxPercent = later.timeOfMaxPercent;
    }
    seen.largestStep = std::max(seen.largestStep, later.largestStep);
    seen.worstHalfSteps = std::max(seen.worstHalfSteps, later.worstHalfSteps);
    seen.squares += later.squares;
}

ChannelComparison comparisonOf(const Seen &seen, const Measure &measure)
{
    ChannelComparison result;
    result.channel = measure.reference.channel;
    result.count = seen.count;
    result.missingModel = seen.missingModel;
    result.zeroReference = seen.zeroReference;
    result.withinHalfStep = seen.withinHalfStep;
    result.worstHalfSteps = seen.worstHalfSteps;
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

std::vector<Measure> measuresOf(const Mechanism &mechanism, const ReferenceData &reference)
{
    std::vector<Measure> measures;
    for (const ReferenceSeries &series : reference.series) {
        measures.push_back(measureOf(series, naturalScale(mechanism, series.channel)));
    }
    return measures;
}

} // namespace

ChannelComparison compareChannel(std::span<const double> time, std::span<const double> model,
                                 const ReferenceSeries &reference, double scale)
{
    const std::span<const double> values(reference.values);
    assert(model.size() == time.size() && values.size() == time.size());
    const Measure measure = measureOf(reference, scale);
    Seen seen;
    for (std::size_t from = 0; from < time.size(); from += kBlock) {
        const std::size_t count = std::min(kBlock, time.size() - from);
        add(seen, seenIn(time.subspan(from, count), model.subspan(from, count), values.subspan(from, count), measure));
    }
    return comparisonOf(seen, measure);
}

ExactComparison compareExactly(const Mechanism &mechanism, const ReferenceData &reference, std::stop_token stop)
{
    const std::span<const double> time(reference.time);
    const std::vector<Measure> measures = measuresOf(mechanism, reference);
    const std::size_t blocks = (time.size() + kBlock - 1) / kBlock;
    std::vector<Seen> seen(blocks * measures.size()); // by block, then by series
    ExactComparison result;
    result.status.resize(time.size());
    const ChannelSet channels = channelsOf(reference);
    SolverSettings exact;
    exact.method = Method::ClosedForm;
    const auto compareBlock = [&](std::size_t block) {
        const std::size_t from = block * kBlock;
        const std::span<const double> instants = time.subspan(from, std::min(kBlock, time.size() - from));
        const Trajectory model = sample(mechanism, {instants.begin(), instants.end()}, channels, exact, stop);
        std::copy(model.status.begin(), model.status.end(), result.status.begin() + static_cast<std::ptrdiff_t>(from));
        for (std::size_t i = 0; i < measures.size(); ++i) {
            const ReferenceSeries &series = measures[i].reference;
            seen[block * measures.size() + i] = seenIn(
                instants, model[series.channel], std::span(series.values).subspan(from, instants.size()), measures[i]);
        }
    };
    inParallel(blocks, compareBlock, time.size() > kWorthAThread);
    for (std::size_t i = 0; i < measures.size(); ++i) {
        Seen all;
        for (std::size_t block = 0; block < blocks; ++block) {
            add(all, seen[block * measures.size() + i]);
        }
        result.channels.push_back(comparisonOf(all, measures[i]));
    }
    return result;
}

std::vector<ChannelComparison> compare(const Mechanism &mechanism, const Trajectory &model,
                                       const ReferenceData &reference)
{
    std::vector<ChannelComparison> comparisons(reference.series.size());
    const auto compareOne = [&](std::size_t i) {
        const ReferenceSeries &series = reference.series[i];
        comparisons[i] =
            compareChannel(reference.time, model[series.channel], series, naturalScale(mechanism, series.channel));
    };
    inParallel(comparisons.size(), compareOne, reference.time.size() > kWorthAThread);
    return comparisons;
}

} // namespace slidercrank
