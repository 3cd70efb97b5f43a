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

/// Adds a column to the convention of the same kind and amount, or appends a new convention. Origins are never
/// combined, because each has its own standard error.
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

/// Appends what has to be done with a column so that it contains `channel`. `error`: of the origin, in the unit of
/// files.
void appendReading(std::vector<ConventionFinding> &conventions, Channel channel, const ColumnReading &reading,
                   bool hadJumps, double error)
{
    constexpr double kTolerance = 1e-9; // of half turns, relative to one
    const bool isAnAngle = isAngle(channel.coordinate);
    if (std::abs(reading.factor) != 1.0) {
        append(conventions, isAnAngle ? Kind::AngleUnit : Kind::LengthUnit, channel, 1.0 / std::abs(reading.factor));
    }
    if (reading.factor < 0.0) {
        append(conventions, Kind::Sign, channel, -1.0);
    }
    const double amount = toFileUnit(channel, -reading.origin / reading.factor);
    const double halfTurns = isAnAngle ? std::rint(amount / 180.0) : 0.0;
    const bool isOfHalfTurns = std::abs(amount - 180.0 * halfTurns) < kTolerance * 180.0;
    const bool isWhole = std::fmod(halfTurns, 2.0) == 0.0;
    if (isOfHalfTurns && isWhole && channel == kCrankAngle) {
        return; // crank angles are compared up to whole turns
    }
    if (isOfHalfTurns && (halfTurns != 0.0 || hadJumps)) {
        append(conventions, isWhole ? Kind::WholeTurns : Kind::HalfTurn, channel, 180.0 * halfTurns);
    } else if (!isOfHalfTurns) {
        if (hadJumps) {
            append(conventions, Kind::WholeTurns, channel, 0.0);
        }
        append(conventions, Kind::ZeroPoint, channel, amount);
        conventions.back().standardError = error;
    }
}

/// The positions of a file over its θ2, rising, as a table over the crank angle.
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
    const auto selected = [&](const std::vector<double> &values) {
        std::vector<double> some(rows.size());
        std::ranges::transform(rows, some.begin(), [&](std::size_t row) { return values[row]; });
        return some;
    };
    ReferenceData table;
    table.crank = CrankAngles{.degrees = selected(degrees), .rounding = crank.rounding};
    for (const ReferenceSeries &series : data.series) {
        if (series.channel.order == Order::Position && series.channel != kCrankAngle) {
            table.series.push_back({series.channel, selected(series.values), series.rounding});
        }
    }
    return table;
}

/// The largest error of some channels (of all without any), in percent of their peaks.
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

std::vector<ConventionFinding> conventionsOf(const LastFit &lastFit)
{
    const Observations &observations = lastFit.observations;
    const Fit &fit = lastFit.fit;
    const Model &model = fit.model;
    std::vector<ConventionFinding> conventions;
    if (model.followsAngle) {
        // θ2 = factor · angle + origin
        const ColumnReading reading{1.0 / model.angleFactor, -wrapToPi(model.mechanism.theta20) / model.angleFactor};
        const double error = lastFit.errorOf({Unknown::Kind::CrankAngle}) * kDegreesPerRadian;
        appendReading(conventions, kCrankAngle, reading, false, error);
    }
    Indices columns = fit.columns; // in the order of the file
    std::ranges::sort(columns);
    for (const Index k : columns) {
        const ObservedColumn &column = observations.columns[k];
        const double error = toFileUnit(column.channel, lastFit.errorOf({Unknown::Kind::Origin, k}));
        appendReading(conventions, column.channel, model.readings[k], column.hadJumps, error);
    }
    return conventions;
}

ReferenceData allApplied(const std::vector<ConventionFinding> &conventions, ReferenceData data)
{
    for (const ConventionFinding &finding : conventions) {
        data = applied(finding.convention, std::move(data));
    }
    return data;
}

std::vector<ChannelComparison> compareRead(const Parameters &mechanism, const ReferenceData &data, Drive::Kind drive,
                                           const FittedMechanism &fitted, const std::stop_token &stop)
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
    const auto compareWith = [&](const std::vector<ConventionFinding> &applied, const Parameters &parameters) {
        return compareRead(parameters, allApplied(applied, data), drive, {}, {});
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
