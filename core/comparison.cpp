// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/comparison.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <thread>
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

} // namespace

ChannelComparison compareChannel(std::span<const double> time, std::span<const double> model,
                                 const ReferenceSeries &reference, double scale)
{
    const std::vector<double> &values = reference.values;
    assert(model.size() == time.size() && values.size() == time.size());

    double peak = 0.0;
    for (const double value : values) {
        if (std::isfinite(value)) {
            peak = std::max(peak, std::abs(value));
        }
    }
    const double smallestStep = kArithmeticStep * std::max(peak, scale);

    ChannelComparison result;
    result.channel = reference.channel;
    double maxAbs = -1.0;
    double maxPercent = -1.0;
    double largestStep = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double value = values[i];
        if (!std::isfinite(value)) {
            continue;
        }
        const double stepOfFile = reference.rounding.stepAt(value);
        largestStep = std::max(largestStep, stepOfFile);
        if (!std::isfinite(model[i])) {
            ++result.missingModel;
            continue;
        }
        ++result.count;
        const double error = std::abs(model[i] - value);
        if (error > maxAbs) {
            maxAbs = error;
            result.timeOfMaxAbs = time[i];
        }
        const double percent = value == 0.0 ? std::numeric_limits<double>::infinity() : error / std::abs(value) * 100.0;
        if (!std::isfinite(percent)) {
            ++result.zeroReference;
        } else if (percent > maxPercent) {
            maxPercent = percent;
            result.timeOfMaxPercent = time[i];
        }

        const double step = std::max(stepOfFile, smallestStep);
        const double half = 0.5 * step + kUlpSlack * std::numeric_limits<double>::epsilon() * std::abs(value);
        if (error <= half) {
            ++result.withinHalfStep;
        }
        if (error > result.worstHalfSteps * half) { // a quotient only where it can be the largest
            result.worstHalfSteps = error / half;
        }
    }
    result.verdict = verdictOf(result);

    if (reference.rounding.rule != Rounding::Rule::Unknown && largestStep > 0.0) {
        result.roundingStep = largestStep;
    }
    if (maxPercent >= 0.0) {
        result.maxPercent = maxPercent;
    }
    if (result.count == 0) {
        return result;
    }
    result.maxAbs = maxAbs;
    if (peak > 0.0) {
        result.percentOfPeak = maxAbs / peak * 100.0;
    }
    // Relative to the largest, so that no square over- or underflows.
    double sum = 0.0;
    for (std::size_t i = 0; i < time.size() && maxAbs > 0.0; ++i) {
        if (std::isfinite(values[i]) && std::isfinite(model[i])) {
            const double part = (model[i] - values[i]) / maxAbs;
            sum += part * part;
        }
    }
    result.rms = maxAbs * std::sqrt(sum / static_cast<double>(result.count));
    return result;
}

std::vector<ChannelComparison> compare(const Mechanism &mechanism, const Trajectory &model,
                                       const ReferenceData &reference)
{
    const std::size_t count = reference.series.size();
    std::vector<ChannelComparison> comparisons(count);
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            const ReferenceSeries &series = reference.series[i];
            comparisons[i] =
                compareChannel(reference.time, model[series.channel], series, naturalScale(mechanism, series.channel));
        }
    };
    constexpr std::size_t kWorthAThread = 50000; // instants
    std::vector<std::jthread> aside;
    if (reference.time.size() > kWorthAThread) {
        const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
        for (std::size_t i = 1; i < std::min(processors, count); ++i) {
            aside.emplace_back(work);
        }
    }
    work();
    aside.clear(); // waits for them
    return comparisons;
}

} // namespace slidercrank
