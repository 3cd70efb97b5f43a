// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/explanation.h"

#include "core/identification/round_numbers.h"
#include "core/identification/unit_and_sense.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

/// So many instants decide; of a longer file no more are looked at.
constexpr std::size_t kMostRows = 400;
/// Instants that one swing of a column must keep, or what lies between them is lost.
constexpr std::size_t kRowsPerSwing = 20;

/// Instants on which phases are compared before all of them are.
constexpr std::size_t kScanRows = 64;
/// Phases of a turn that are tried for a late start: no motion has more than a few extremes a turn.
constexpr int kPhases = 128;
/// A column is the motion with a shift when its root mean square error is no larger, as part of how much it varies.
constexpr double kLikely = 0.05;

/// Where f is least between the two, if it has one minimum there.
template <class Function>
double minimumBetween(double low, double high, Function f)
{
    constexpr int kBits = 26; // no finer can be seen in f
    std::uintmax_t most = 50;
    return boost::math::tools::brent_find_minima(f, low, high, kBits, most).first;
}

Parameters started(Parameters parameters, double shift)
{
    // At the end of what a mechanism may have, a turn is next to nothing.
    parameters.theta20 =
        std::clamp(parameters.theta20 + parameters.omega2 * shift, -kLargestParameter, kLargestParameter);
    return parameters;
}

/// Shifts of time with which one of the columns at least is the mechanism's motion.
std::vector<double> likelyShifts(const ReferenceData &data, const Parameters &parameters)
{
    ReferenceData few = everySoManyth(data, kScanRows);
    std::erase_if(few.series, [](const ReferenceSeries &series) { return !isPlotted(series.channel); });
    const std::vector<ReferenceSeries> &columns = few.series;
    const ChannelSet channels = channelsOf(few);

    const double period = 2.0 * std::numbers::pi / std::abs(parameters.omega2);
    if (!std::isfinite(period)) {
        return {};
    }
    const auto shiftAt = [period](int phase) { return period * (static_cast<double>(phase) / kPhases - 0.5); };
    std::vector<std::array<double, kPhases>> misfits(columns.size());
    for (int phase = 0; phase < kPhases; ++phase) {
        const Trajectory model = motionOf(started(parameters, shiftAt(phase)), few.time, channels);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            misfits[k][static_cast<std::size_t>(phase)] = rmsMisfit(columns[k].values, model[columns[k].channel]);
        }
    }
    std::vector<double> shifts;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const Channel channel = columns[k].channel;
        const auto best = static_cast<int>(std::min_element(misfits[k].begin(), misfits[k].end()) - misfits[k].begin());
        const auto misfit = [&](double shift) {
            ChannelSet only;
            only.set(indexOf(channel));
            return rmsMisfit(columns[k].values, motionOf(started(parameters, shift), few.time, only)[channel]);
        };
        const double shift = minimumBetween(shiftAt(best - 1), shiftAt(best + 1), misfit);
        const auto isSame = [&](double other) { return std::abs(shift - other) < period / (100.0 * kPhases); };
        if (misfit(shift) <= kLikely && std::none_of(shifts.begin(), shifts.end(), isSame)) {
            shifts.push_back(shift);
        }
    }
    return shifts;
}

/// The same explanation with the shift that serves all columns best.
Explanation withBestShift(const ReferenceData &data, Explanation explanation)
{
    const auto shift = std::find_if(explanation.conventions.begin(), explanation.conventions.end(),
                                    [](const Convention &one) { return one.kind == Kind::TimeShift; });
    const ReadMotion motion(data, explanation);
    const ChannelSet channels = channelsOf(motion.read) & plottedChannels();
    const auto misfit = [&](double more) {
        const Trajectory model = motionOf(started(explanation.parameters, more), motion.read.time, channels);
        double sum = 0.0;
        for (const ReferenceSeries &series : motion.read.series) {
            if (isPlotted(series.channel)) {
                const double one = rmsMisfit(series.values, model[series.channel]);
                sum += one * one;
            }
        }
        return sum;
    };
    const double near = 2.0 * std::numbers::pi / std::abs(explanation.parameters.omega2) / (100.0 * kPhases);
    const double best = minimumBetween(-near, near, misfit);
    shift->amount += best;

    // The sum of squares grows with the square of the distance from the best: that gives its standard error, within
    // which a round number is the better guess of how late a clock was started.
    const double least = misfit(best);
    const double growth = misfit(best + near) - least;
    const double standardError = near * std::sqrt(least / growth / static_cast<double>(motion.read.time.size()));
    if (standardError > 0.0 && std::isfinite(standardError)) {
        shift->amount = roundest(shift->amount, standardError, std::array{1.0});
    }
    return explanation;
}

/// How often a column goes all the way up, from the lowest to the highest quarter of its range.
std::size_t swingsOf(std::span<const double> values)
{
    const ValueRange range = rangeOf(values);
    const double low = range.low + 0.25 * range.width();
    const double high = range.high - 0.25 * range.width();
    std::size_t swings = 0;
    bool down = false;
    for (const double value : values) {
        if (down && value > high) {
            down = false;
            ++swings;
        } else if (value < low) {
            down = true;
        }
    }
    return swings;
}

/// The file, or so many instants from its start on that the motion is still to be seen between them.
ReferenceData decisiveRows(const ReferenceData &data, const std::stop_token &stop)
{
    const std::size_t rows = data.time.size();
    std::size_t stride = 1;
    if (rows > kMostRows) {
        std::size_t swings = 1;
        for (const ReferenceSeries &series : data.series) {
            if (stop.stop_requested()) {
                return {};
            }
            swings = std::max(swings, swingsOf(series.values));
        }
        stride = std::clamp<std::size_t>(rows / (swings * kRowsPerSwing), 1, rows / kMostRows);
    }

    ReferenceData some;
    some.timeRounding = data.timeRounding;
    for (const ReferenceSeries &series : data.series) {
        some.series.push_back({series.channel, {}, series.rounding});
    }
    for (std::size_t i = 0; i < kMostRows && i * stride < rows; ++i) {
        // Not exactly every so manieth: a column may have a value in every tenth row only.
        const std::size_t row = std::min(i * stride + i % std::min<std::size_t>(stride, 13), rows - 1);
        some.time.push_back(data.time[row]);
        for (std::size_t k = 0; k < data.series.size(); ++k) {
            some.series[k].values.push_back(data.series[k].values[row]);
        }
    }
    std::erase_if(some.series,
                  [](const ReferenceSeries &series) { return rangeOf(series.values).count < kFewestValues; });
    return some;
}

/// Keeps the cheapest explanation.
void prefer(std::optional<Explanation> &best, std::optional<Explanation> candidate)
{
    if (candidate && (!best || costOf(*candidate) < costOf(*best))) {
        best = std::move(candidate);
    }
}

} // namespace

std::optional<Explanation> explainedAtHand(const ReferenceData &all, const Parameters &parameters,
                                           const std::stop_token &stop)
{
    const ReferenceData data = decisiveRows(all, stop);
    if (stop.stop_requested() || std::ranges::none_of(data.series, isPlotted, &ReferenceSeries::channel)) {
        return std::nullopt;
    }
    std::vector<Explanation> assumptions;
    for (const Branch branch : {parameters.branch, oppositeBranch(parameters.branch)}) {
        for (const double timeUnit : {1.0, kTimeUnits[0], kTimeUnits[1]}) {
            Explanation assumption{parameters, {}, timeUnit};
            if (branch != parameters.branch) {
                assumption.parameters.branch = branch;
                assumption.conventions.push_back({Kind::Branch, {}, 1.0});
            }
            if (timeUnit != 1.0) {
                assumption.conventions.push_back({Kind::TimeUnit, {}, timeUnit});
            }
            assumptions.push_back(assumption);
        }
    }

    std::optional<Explanation> best;
    for (const Explanation &assumption : assumptions) {
        if (const auto explanation = explain(data, assumption)) {
            prefer(best, proven(data, *explanation));
        }
    }
    if (best) {
        return best;
    }
    for (const Explanation &assumption : assumptions) {
        if (stop.stop_requested()) {
            return std::nullopt;
        }
        for (const double shift : likelyShifts(allApplied(assumption.conventions, data), assumption.parameters)) {
            Explanation late = assumption;
            late.conventions.push_back({Kind::TimeShift, {}, shift});
            if (const auto explanation = explain(data, late)) {
                prefer(best, proven(data, withBestShift(data, *explanation)));
            }
        }
    }
    return best;
}

} // namespace slidercrank
