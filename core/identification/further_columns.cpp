// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/further_columns.h"

#include "core/identification/column_scale.h"
#include "core/identification/geometry.h"
#include "core/identification/rounding_test.h"
#include "core/identification/table_speed.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

using Reason = LeftOutColumn::Reason;

/// The usual factor, ±1 or a unit conversion, that is nearest to the one with which the prediction fits a column.
double usualFactor(const Observations &observations, const Fit &fit, Index k, bool areExact)
{
    const Channel channel = observations.columns[k].channel;
    const ColumnScale scale = scaleOf(observations, fit, fit.model, k, areExact);
    const double sign = signOfCoordinate(observations, fit, channel.coordinate) * std::copysign(1.0, scale.factor);
    if (channel == kSliderLine) {
        return 1.0; // a constant has no scale of its own, and zeros have no sign
    }
    if (observations.columns[k].range == 0.0 && channel.coordinate != Theta2) {
        return signOfCoordinate(observations, fit, channel.coordinate);
    }
    if (channel.coordinate == Theta2) {
        return sign;
    }
    const auto mismatch = [&](double unit) { return std::abs(std::log(std::abs(scale.factor) / unit)); };
    return sign * std::ranges::min(unitFactors(channel), {}, mismatch);
}

/// The origin with which the prediction fits a column of positions best: 0 if the column is one of derivatives.
double bestOrigin(const Observations &observations, const Fit &fit, Index k, double factor)
{
    const ObservedColumn &column = observations.columns[k];
    const Values differences = column.values - factor * motionIn(fit.model, observations, {k}).col(0);
    return column.channel.order == Order::Position ? median(differences) : 0.0;
}

/// The size with which the residuals of a column are compared: its range, or a, because R4_y has no range of its own.
double sizeOf(const Observations &observations, const Fit &fit, Index k)
{
    const ObservedColumn &column = observations.columns[k];
    return column.channel == kSliderLine ? fit.model.mechanism.a : column.range;
}

/// Adds a column to a fit, starting from `model`. The result is not finite if the column and the others are not
/// explained together.
Fit withColumn(const Observations &observations, const Fit &fit, const Model &model, Index k, bool areExact)
{
    Indices columns = fit.columns;
    columns.push_back(k);
    Fit next = refined(observations, model, columns, fit.unknowns);
    if (!next.isFinite()) {
        return next;
    }
    const Fit others = evaluated(observations, next.model, fit.columns);
    const bool isExplained = isWithinRounding(observations, next, std::ssize(columns) - 1) ||
                             next.rms.back() < largestFurtherResidual(areExact) * sizeOf(observations, next, k);
    const bool spoilsOthers = others.misfit - fit.misfit > kSameMisfit && !(areExact && isExact(observations, others));
    next.misfit = isExplained && !spoilsOthers ? next.misfit : kInfinity;
    return next;
}

/// Adds a column: in its usual reading or, if it contains positions, also with the other sign, by half turns of an
/// angle, and with an origin.
Fit withUsualReading(const Observations &observations, const Fit &fit, Index k, bool areExact)
{
    const ObservedColumn &column = observations.columns[k];
    const double factor = usualFactor(observations, fit, k, areExact);
    std::vector<ColumnReading> readings{{factor, 0.0}};
    if (std::abs(factor) != 1.0 && !fit.model.followsAngle) { // another unit only if it is necessary
        readings.insert(readings.begin(), {std::copysign(1.0, factor), 0.0});
    }
    const bool isMoving = column.range > 0.0 || column.channel == kSliderLine;
    const bool mayHaveOrigin = column.channel.order == Order::Position && isMoving;
    if (mayHaveOrigin) {
        for (const double sign : {1.0, -1.0}) {
            const double origin = bestOrigin(observations, fit, k, sign * factor);
            const double halfTurn = isAngle(column.channel.coordinate) ? std::numbers::pi : kInfinity;
            readings.push_back(
                {sign * factor, std::isfinite(halfTurn) ? halfTurn * std::rint(origin / halfTurn) : 0.0});
        }
    }
    Model model = fit.model;
    Fit next;
    for (std::size_t i = 0; i < readings.size() && !next.isFinite(); ++i) {
        model.readings[k] = readings[i];
        next = withColumn(observations, fit, model, k, areExact);
    }
    if (!next.isFinite() && mayHaveOrigin) {
        model.readings[k] = {factor, bestOrigin(observations, fit, k, factor)};
        Fit withOrigin = fit;
        withOrigin.unknowns.push_back({Unknown::Kind::Origin, k});
        next = withColumn(observations, withOrigin, model, k, areExact);
    }
    return next;
}

/// Whether a slider-crank of other proportions, with the same speed, explains the column.
bool isMotionOfOtherLengths(const Observations &observations, const Fit &fit, Index k)
{
    constexpr double kFewestValues = 20.0; // fewer prove nothing
    if (observations.columns[k].range == 0.0) {
        return false;
    }
    constexpr double kSame = 3e-3; // of the proportions; a column that lags has the same ones
    const Fit alone =
        refined(observations, fit.model, {k},
                {{Unknown::Kind::A}, {Unknown::Kind::B}, {Unknown::Kind::C}, {Unknown::Kind::CrankAngle}});
    const auto differ = [&](double length, double other) {
        const Parameters &m = fit.model.mechanism;
        const Parameters &changed = alone.model.mechanism;
        return std::abs(length / changed.a - other / m.a) > kSame * (m.b + std::abs(m.c)) / m.a;
    };
    return alone.isFinite() && alone.counts[0] >= kFewestValues && isWithinRounding(observations, alone, 0) &&
           (differ(alone.model.mechanism.b, fit.model.mechanism.b) ||
            differ(alone.model.mechanism.c, fit.model.mechanism.c));
}

/// The largest deviation of a column from the prediction times a factor, in percent of its peak.
double percentOfPeak(const Observations &observations, const Fit &fit, Index k, double factor)
{
    Model model = fit.model;
    model.readings[k] = {factor, 0.0};
    const Fit alone = evaluated(observations, model, {k});
    const double peak = std::max(finite(observations.columns[k].values).abs().maxCoeff(),
                                 finite(alone.residuals.col(0)).abs().maxCoeff()); // of zeros: of the prediction
    return peak > 0.0 ? 100.0 * finite(alone.residuals.col(0)).abs().maxCoeff() / peak : kNone;
}

/// Whether fit.columns[k], which contains difference quotients within their rounding, is nevertheless the motion:
/// quotients amplify the rounding of the lower column, and the residuals of genuine derivatives are those of their own.
bool isGenuine(const Observations &observations, const Fit &fit, Index k)
{
    constexpr double kRoundings = 3.0;
    return isWithinRounding(observations, fit, k) ||
           fit.rms[k] < kRoundings * std::sqrt(observations.columns[fit.columns[k]].variance);
}

/// Adds a column to result.fit, or to result.leftOut.
void addOrLeaveOut(FurtherColumns &result, const Observations &observations, Index k, Drive::Kind drive, bool areExact)
{
    const Channel channel = observations.columns[k].channel;
    const bool isDerivative = channel.order != Order::Position;
    const bool isDifference = observations.columns[k].isDifference;
    LeftOutColumn column{channel, isDifference ? Reason::FiniteDifferences : Reason::Unknown};
    if (isDerivative && drive == Drive::Kind::Uneven) {
        column.reason = Reason::UnevenSpeed;
    } else if (isDerivative && drive == Drive::Kind::OverAngle && !result.fit.changes({Unknown::Kind::Omega2})) {
        column.reason = isDifference ? Reason::FiniteDifferences : Reason::OpenSpeed;
        const ColumnScale scale = scaleOf(observations, result.fit, result.fit.model, k, areExact);
        const double sign = signOfCoordinate(observations, result.fit, channel.coordinate);
        column.percentOfPeak = percentOfPeak(observations, result.fit, k, sign * scale.factor);
    } else {
        Fit next = withUsualReading(observations, result.fit, k, areExact);
        const Index last = std::ssize(next.columns) - 1;
        if (next.isFinite() && (!isDifference || isGenuine(observations, next, last))) {
            result.fit = std::move(next);
            return;
        }
        column.percentOfPeak =
            percentOfPeak(observations, result.fit, k, usualFactor(observations, result.fit, k, areExact));
        if (!isDifference && channel != kSliderLine && isMotionOfOtherLengths(observations, result.fit, k)) {
            column.reason = Reason::OtherMotion;
        }
    }
    result.leftOut.push_back(column);
}

} // namespace

FurtherColumns withFurtherColumns(const Observations &observations, const Fit &fit, const Drive &drive,
                                  const Parameters &given)
{
    FurtherColumns result{.fit = drive.kind == Drive::Kind::OverTime ? withSpeedOfVelocities(observations, fit) : fit};
    const bool areExact = isExact(observations, result.fit);
    const auto isOfAngle = [&](Index k) { return isAngle(observations.columns[k].channel.coordinate); };
    const bool canShowSpeed =
        determineLengths(observations, fit.columns) || std::ranges::all_of(fit.columns, isOfAngle);
    if (drive.kind == Drive::Kind::OverAngle && !fit.changes({Unknown::Kind::Omega2}) && canShowSpeed) {
        result.speeds = speedsOfTable(observations, fit, given.omega2);
        if (result.speeds.size() == 1) {
            result.fit.unknowns.push_back({Unknown::Kind::Omega2});
            result.fit.model.mechanism.omega2 = result.speeds[0];
        }
    }
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        for (Index k = 0; k < std::ssize(observations.columns); ++k) {
            if (observations.columns[k].channel.order == order && !result.fit.uses(k)) {
                addOrLeaveOut(result, observations, k, drive.kind, areExact);
            }
        }
    }
    const auto isDerivative = [&](Index k) { return observations.columns[k].channel.order != Order::Position; };
    if (drive.kind == Drive::Kind::OverAngle && std::ranges::none_of(result.fit.columns, isDerivative)) {
        std::erase(result.fit.unknowns, Unknown{Unknown::Kind::Omega2}); // no column that voted for it is used
        result.fit.model.mechanism.omega2 = given.omega2;
    }
    return result;
}

} // namespace slidercrank
