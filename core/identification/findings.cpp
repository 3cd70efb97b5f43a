// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/findings.h"

#include "core/import/crank_angles.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

/// Adds a column to the convention of this kind and amount; appends a new convention if there is none. Origins are
/// never combined, because each has its own standard error.
void append(std::vector<ConventionFinding> &conventions, Kind kind, Channel channel, double amount)
{
    for (ConventionFinding &finding : conventions) {
        Convention &convention = finding.convention;
        if (convention.kind == kind && convention.amount == amount && kind != Kind::ZeroPoint) {
            convention.channels.push_back(channel);
            return;
        }
    }
    conventions.push_back({{kind, {channel}, amount}});
}

/// Appends the convention that adds `amount` (° or mm) to a column. `hadJumps`: jumps by whole turns have to be removed
/// from it. `error`: standard error of an amount that is not usual.
void appendShift(std::vector<ConventionFinding> &conventions, Channel channel, double amount, bool hadJumps,
                 double error)
{
    constexpr double kHalfTurn = 180.0;
    // ° or mm: far above the rounding errors of an amount that is usual, far below an origin that matters.
    constexpr double kArithmetic = 2e-7;
    const double usual = isAngle(channel.coordinate) ? kHalfTurn * std::rint(amount / kHalfTurn) : 0.0;
    const bool areWholeTurns = std::fmod(usual, 2.0 * kHalfTurn) == 0.0;
    if (std::abs(amount - usual) > kArithmetic) {
        if (hadJumps) {
            append(conventions, Kind::WholeTurns, channel, 0.0);
        }
        append(conventions, Kind::ZeroPoint, channel, amount);
        conventions.back().standardError = error;
    } else if (!areWholeTurns) {
        append(conventions, Kind::HalfTurn, channel, usual);
    } else if (channel != kCrankAngle && (usual != 0.0 || hadJumps)) { // crank angles are compared up to whole turns
        append(conventions, Kind::WholeTurns, channel, usual);
    }
}

/// Appends the conventions that turn a column into `channel`: value = factor · motion + origin, so that the motion is
/// value / factor - origin / factor. `error`: standard error of the origin, in the unit of files.
void appendReading(std::vector<ConventionFinding> &conventions, Channel channel, const ColumnReading &reading,
                   bool hadJumps, double error)
{
    const double unit = std::abs(reading.factor);
    if (unit != 1.0) {
        append(conventions, isAngle(channel.coordinate) ? Kind::AngleUnit : Kind::LengthUnit, channel, 1.0 / unit);
    }
    if (reading.factor < 0.0) {
        append(conventions, Kind::Sign, channel, -1.0);
    }
    appendShift(conventions, channel, toFileUnit(channel, -reading.origin / reading.factor), hadJumps, error);
}

/// The positions of a file as a table over the crank angle, sorted by its θ2. Of rows with the same θ2, the first.
ReferenceData tableOverAngle(const ReferenceData &data)
{
    const ReferenceSeries &crank = *data.find(kCrankAngle);
    std::vector<double> degrees = crank.values;
    removeJumps(degrees, 360.0);
    std::vector<std::size_t> rows(degrees.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return degrees[row]; });
    const auto isRepeated = [&](std::size_t row, std::size_t next) { return degrees[row] == degrees[next]; };
    rows.erase(std::unique(rows.begin(), rows.end(), isRepeated), rows.end());
    const auto inTable = [&](const std::vector<double> &values) {
        std::vector<double> sorted(rows.size());
        std::ranges::transform(rows, sorted.begin(), [&](std::size_t row) { return values[row]; });
        return sorted;
    };
    ReferenceData table;
    table.crank = CrankAngles{.degrees = inTable(degrees), .rounding = crank.rounding};
    for (const ReferenceSeries &series : data.series) {
        if (series.channel.order == Order::Position && series.channel != kCrankAngle) {
            table.series.push_back({series.channel, inTable(series.values), series.rounding});
        }
    }
    return table;
}

/// The largest error of the given channels, in percent of their peaks; of all channels if none is given.
double largestPercent(const std::vector<ChannelComparison> &comparisons, const std::vector<Channel> &channels)
{
    double largest = 0.0;
    for (const ChannelComparison &comparison : comparisons) {
        if (channels.empty() || std::ranges::find(channels, comparison.channel) != channels.end()) {
            largest = std::max(largest, comparison.percentOfPeak.value_or(0.0));
        }
    }
    return largest;
}

} // namespace

std::vector<ConventionFinding> listConventions(const LastFit &lastFit)
{
    const Observations &observations = lastFit.observations;
    const Fit &fit = lastFit.fit;
    const Model &model = fit.model;
    std::vector<ConventionFinding> conventions;
    if (model.followsAngle) {
        // θ2 = factor · angle + origin
        const ColumnReading reading{1.0 / model.angleFactor, -wrapToPi(model.mechanism.theta20) / model.angleFactor};
        const double error = lastFit.standardErrorOf({Unknown::Kind::CrankAngle}) * kDegreesPerRadian;
        appendReading(conventions, kCrankAngle, reading, false, error);
    }
    Indices columns = fit.columns; // in the order of the file
    std::ranges::sort(columns);
    for (const Index k : columns) {
        const ObservedColumn &column = observations.columns[k];
        const double error = toFileUnit(column.channel, lastFit.standardErrorOf({Unknown::Kind::Origin, k}));
        appendReading(conventions, column.channel, model.readings[k], column.hadJumps, error);
    }
    return conventions;
}

ReferenceData applyAll(const std::vector<ConventionFinding> &conventions, ReferenceData data)
{
    for (const ConventionFinding &finding : conventions) {
        data = applied(finding.convention, std::move(data));
    }
    return data;
}

std::vector<ChannelComparison> compareReadFile(const Parameters &mechanism, const ReferenceData &data,
                                               Drive::Kind drive, const FittedMechanism &fitted,
                                               const std::stop_token &stop)
{
    const bool overAngle =
        drive == Drive::Kind::RunUp || drive == Drive::Kind::Uneven || (drive == Drive::Kind::OverAngle && !data.crank);
    // A table over the angle is compared as if the crank turned by one radian per second from 0.
    constexpr double kUnitSpeed = 1.0;
    constexpr double kStartAngle = 0.0;
    const Mechanism timed = overAngle ? withDrive(Mechanism(mechanism), kUnitSpeed, kStartAngle) : Mechanism(mechanism);
    const std::optional<ReferenceData> reference = timedBy(timed, overAngle ? tableOverAngle(data) : data);
    return reference ? compareExactly(timed, *reference, stop, fitted).channels : std::vector<ChannelComparison>();
}

void measureConventions(std::vector<ConventionFinding> &conventions, const Parameters &mechanism,
                        const ReferenceData &data, Drive::Kind drive)
{
    const FittedMechanism notFitted{}; // the percentages do not depend on how the mechanism was fitted
    const std::stop_token neverStopped{};
    const auto compareWith = [&](const std::vector<ConventionFinding> &applied, const Parameters &parameters) {
        return compareReadFile(parameters, applyAll(applied, data), drive, notFitted, neverStopped);
    };
    const std::vector<ChannelComparison> after =
        conventions.empty() ? std::vector<ChannelComparison>() : compareWith(conventions, mechanism);
    for (std::size_t i = 0; i < conventions.size(); ++i) {
        const Convention &convention = conventions[i].convention;
        std::vector<ConventionFinding> others = conventions;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        Parameters without = mechanism;
        without.branch = convention.kind == Kind::Branch ? oppositeBranch(mechanism.branch) : mechanism.branch;
        const bool concernsAll =
            convention.kind == Kind::TimeUnit || convention.kind == Kind::Axis || concerns(convention, kCrankAngle);
        const std::vector<Channel> channels = concernsAll ? std::vector<Channel>() : convention.channels;
        conventions[i].before = largestPercent(compareWith(others, without), channels);
        conventions[i].after = largestPercent(after, channels);
    }
}

} // namespace slidercrank
