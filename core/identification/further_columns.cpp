// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/further_columns.h"

#include "core/identification/column_scale.h"
#include "core/identification/geometry.h"
#include "core/identification/joint_fit.h"
#include "core/identification/residual_test.h"
#include "core/identification/table_speed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

using Reason = LeftOutColumn::Reason;

/// The origin with which the prediction, multiplied by a factor, fits a column of positions best; 0 for derivatives.
double bestOrigin(const Observations &observations, const Fit &fit, Index k, double factor)
{
    const ObservedColumn &column = observations.columns[k];
    const Values differences = column.values - factor * computeMotion(fit.model, observations, {k}).col(0);
    return column.isDerivative() ? 0.0 : median(differences);
}

/// Whether an origin of the column can be told from the motion: that of a position that changes, or of R4_y.
bool mayHaveOrigin(const ObservedColumn &column)
{
    return !column.isDerivative() && (!column.isConstant() || column.channel == kSliderLine);
}

/// The readings of a column that are tried before one with a free origin, the simplest first. `factor`: the result of
/// usualFactor(), ±1 or ± a conversion of units.
///   1. If |factor| is not 1 and the model follows the time: ±1, the unit that the heading states. (If it follows the
///      angle, findTableSpeeds() has chosen between the units.)
///   2. `factor`.
///   3. For positions: -factor.
/// In 2 and 3, an angle gets the multiple of half a turn that is nearest to its best origin; other origins are 0.
std::vector<ColumnReading> simpleReadings(const Observations &observations, const Fit &fit, Index k, double factor)
{
    const ObservedColumn &column = observations.columns[k];
    std::vector<ColumnReading> readings;
    if (std::abs(factor) != 1.0 && !fit.model.followsAngle) {
        readings.push_back({std::copysign(1.0, factor), 0.0});
    }
    if (!mayHaveOrigin(column)) {
        readings.push_back({factor, 0.0});
        return readings;
    }
    for (const double signedFactor : {factor, -factor}) {
        const double halfTurn = std::numbers::pi * signedFactor;
        const double origin = bestOrigin(observations, fit, k, signedFactor);
        readings.push_back({signedFactor, column.containsAngles() ? halfTurn * std::rint(origin / halfTurn) : 0.0});
    }
    return readings;
}

/// Fits column k together with the columns of a fit, in the simplest reading with which a mechanism explains them all:
/// one of simpleReadings(), otherwise with a free origin. Returns nullopt if there is none.
std::optional<Fit> withSimplestReading(const Observations &observations, const Fit &fit, Index k, bool isGeometryExact)
{
    const double factor = usualFactor(observations, fit, k);
    Model model = fit.model;
    for (const ColumnReading &reading : simpleReadings(observations, fit, k, factor)) {
        model.readings[k] = reading;
        if (std::optional<Fit> together = tryToAddColumn(observations, fit, model, k, isGeometryExact)) {
            return together;
        }
    }
    if (!mayHaveOrigin(observations.columns[k])) {
        return std::nullopt;
    }
    Fit withOrigin = fit;
    withOrigin.unknowns.push_back({Unknown::Kind::Origin, k});
    for (const double signedFactor : {factor, -factor}) {
        model.readings[k] = {signedFactor, bestOrigin(observations, fit, k, signedFactor)};
        if (std::optional<Fit> together = tryToAddColumn(observations, withOrigin, model, k, isGeometryExact)) {
            return together;
        }
    }
    return std::nullopt;
}

/// Whether a slider-crank with proportions other than those of the fit explains the column at the same speed. (A wrong
/// unit changes the lengths, but not the proportions.) A coupler of more than a hundred cranks proves nothing, because
/// its length hardly shows.
bool isMotionOfOtherProportions(const Observations &observations, const Fit &fit, Index k)
{
    constexpr double kMinValues = 20.0; // fewer prove nothing
    constexpr double kMinChange = 3e-3; // of b/a or c/a, relative to (b + |c|)/a: a delayed column changes neither
    if (observations.columns[k].isConstant()) {
        return false;
    }
    const Fit alone =
        fitModel(observations, fit.model, {k},
                 {{Unknown::Kind::A}, {Unknown::Kind::B}, {Unknown::Kind::C}, {Unknown::Kind::CrankAngle}});
    if (!alone.isFinite() || alone.counts[0] < kMinValues || !isWithinRounding(observations, alone, 0)) {
        return false;
    }
    const Parameters &found = fit.model.mechanism;
    const Parameters &other = alone.model.mechanism;
    const double changeOfProportions =
        std::max(std::abs(other.b / other.a - found.b / found.a), std::abs(other.c / other.a - found.c / found.a));
    return !hidesLengths(found) && !hidesLengths(other) &&
           changeOfProportions > kMinChange * (found.b + std::abs(found.c)) / found.a;
}

/// The largest deviation of a column from the prediction times a factor, in percent of the largest magnitude in the
/// column, at most 100 %. NaN if the column and the prediction are zero.
double deviationInPercentOfPeak(const Observations &observations, const Fit &fit, Index k, double factor)
{
    Model model = fit.model;
    model.readings[k] = {factor, 0.0};
    const Fit alone = evaluateModel(observations, model, {k});
    const double deviation = gapsAsZeros(alone.residuals.col(0)).abs().maxCoeff();
    // The deviation may exceed each value, as in a column of zeros. Then it is 100 %.
    const double peak = std::max(gapsAsZeros(observations.columns[k].values).abs().maxCoeff(), deviation);
    return peak > 0.0 ? 100.0 * deviation / peak : kNone;
}

/// Whether the last column of a fit may be used: one that contains difference quotients may be a genuine derivative
/// nevertheless.
bool isLastColumnGenuine(const Observations &observations, const Fit &fit)
{
    const Index place = std::ssize(fit.columns) - 1;
    return !observations.columns[fit.columns[place]].isDifference || isNearRounding(observations, fit, place);
}

/// The same as deviationInPercentOfPeak(), with the factor that suits the column best: a derivative is multiplied by it
/// if the speed of the crank or the unit is another one.
double percentOfPeakAtBestScale(const Observations &observations, const Fit &fit, Index k)
{
    // The scale is relative to this sign, the factor of deviationInPercentOfPeak() is not.
    const double sign = signOfCoordinate(observations, fit, observations.columns[k].channel.coordinate);
    return deviationInPercentOfPeak(observations, fit, k, sign * bestScale(observations, fit, fit.model, k));
}

/// Largest deviation at the best scale, in percent of the peak, with which a derivative may be that of the mechanism at
/// another speed. If several speeds are possible, the derivatives have smaller deviations.
constexpr double kMaxPercentAtOpenSpeed = 5.0;

/// Why nothing predicts column k of `result`, so that it cannot be compared with the mechanism; nullopt if the
/// mechanism predicts it.
std::optional<Reason> reasonWithoutPrediction(const FurtherColumns &result, const Observations &observations, Index k,
                                              Drive::Kind drive)
{
    const ObservedColumn &column = observations.columns[k];
    if (!column.isDerivative()) {
        return std::nullopt;
    }
    if (drive == Drive::Kind::Uneven) {
        return Reason::UnevenSpeed;
    }
    // In a table, ω2 is an unknown of the fit only if derivatives have shown it before (addSpeedOfTable()).
    const bool isSpeedKnown = drive != Drive::Kind::OverAngle || result.fit.isFree({Unknown::Kind::Omega2});
    if (isSpeedKnown) {
        return std::nullopt;
    }
    if (column.isDifference) { // this is more certain than that another speed would explain the column
        return Reason::FiniteDifferences;
    }
    const bool suitsAnySpeed = percentOfPeakAtBestScale(observations, result.fit, k) < kMaxPercentAtOpenSpeed;
    return suitsAnySpeed ? Reason::OpenSpeed : Reason::Unknown;
}

/// Why column k is left out, which the mechanism predicts but does not explain.
Reason reasonOfMismatch(const Observations &observations, const Fit &fit, Index k)
{
    const ObservedColumn &column = observations.columns[k];
    if (column.isDifference) {
        return Reason::FiniteDifferences;
    }
    const bool isOtherMotion = column.channel != kSliderLine && isMotionOfOtherProportions(observations, fit, k);
    return isOtherMotion ? Reason::OtherMotion : Reason::Unknown;
}

/// Adds column k to result.fit, or to result.leftOut with a reason. `isGeometryExact`: see tryToAddColumn().
void addOrLeaveOut(FurtherColumns &result, const Observations &observations, Index k, Drive::Kind drive,
                   bool isGeometryExact)
{
    const ObservedColumn &column = observations.columns[k];
    const Fit &fit = result.fit;
    if (const std::optional<Reason> reason = reasonWithoutPrediction(result, observations, k, drive)) {
        const double percent = *reason == Reason::UnevenSpeed ? kNone : percentOfPeakAtBestScale(observations, fit, k);
        result.leftOut.push_back({column.channel, *reason, percent});
        return;
    }
    std::optional<Fit> together = withSimplestReading(observations, fit, k, isGeometryExact);
    if (together && isLastColumnGenuine(observations, *together)) {
        result.fit = *std::move(together);
        return;
    }
    const double percent = deviationInPercentOfPeak(observations, fit, k, usualFactor(observations, fit, k));
    result.leftOut.push_back({column.channel, reasonOfMismatch(observations, fit, k), percent});
}

/// Whether the lengths in some columns over the angle of the crank are all velocities, which show only the product a
/// ω2, or all accelerations, which show only a ω2², and no rate of an angle shows ω2.
bool showOnlyProductWithSpeed(const Observations &observations, const Indices &columns)
{
    return !determineLengths(observations, columns) && !observations.containOnlyAngles(columns);
}

/// Multiplies the lengths of a mechanism by a factor.
void scaleLengths(Parameters &mechanism, double factor)
{
    for (const Parameter length : kLengths) {
        valueOf(mechanism, length) *= factor;
    }
}

/// The model of a fit that contains velocities or accelerations of lengths over the angle of the crank, at another
/// speed: the lengths and the signs of the readings change so that these columns remain the same. `order`: that of the
/// columns. Other columns of the fit are angles, which do not depend on the speed.
Model atOtherSpeed(const Observations &observations, const Fit &fit, Order order, double ratioOfSpeeds)
{
    const double factorOfColumns = std::pow(ratioOfSpeeds, static_cast<double>(order));
    Model model = fit.model;
    model.mechanism.omega2 *= ratioOfSpeeds;
    scaleLengths(model.mechanism, 1.0 / std::abs(factorOfColumns));
    for (const Index k : fit.columns) {
        if (observations.columns[k].channel.order == order) {
            model.readings[k].factor *= std::copysign(1.0, factorOfColumns);
        }
    }
    return model;
}

/// By which factor the speed of a fit over the angle of the crank has to change so that the prediction of a column
/// changes by `factorOfColumn` while the columns of the fit remain the same. `order`: that of the column;
/// `fittedOrder`: that of the lengths in the fit. An even power of the speed does not show its sign.
double ratioOfSpeeds(double factorOfColumn, Order order, Order fittedOrder)
{
    const int power = static_cast<int>(order) - static_cast<int>(fittedOrder);
    const double base = power % 2 == 0 ? std::abs(factorOfColumn) : factorOfColumn;
    return std::copysign(std::pow(std::abs(base), 1.0 / power), base);
}

/// Over the angle of the crank, velocities of lengths show the product a ω2, and accelerations a ω2². If a fit of
/// columns of one of these orders (and of angles) has assumed another speed than the true one, it predicts lengths of
/// other orders that are off by a factor, which shows the true speed. Returns the fit together with such a column, in
/// which the speed is free; nullopt if no mechanism explains both, or if the column only contains difference quotients
/// of the other one.
std::optional<Fit> withSpeedOfTwoOrders(const Observations &observations, const Fit &fit, bool isGeometryExact)
{
    const auto isLength = [&](Index k) { return !observations.columns[k].containsAngles(); };
    const Order fittedOrder = observations.columns[*std::ranges::find_if(fit.columns, isLength)].channel.order;
    Fit start = fit;
    start.unknowns.push_back({Unknown::Kind::Omega2});
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const ObservedColumn &column = observations.columns[k];
        if (column.containsAngles() || column.isConstant() || column.channel.order == fittedOrder) {
            continue;
        }
        const double factor = bestScale(observations, fit, fit.model, k);
        start.model =
            atOtherSpeed(observations, fit, fittedOrder, ratioOfSpeeds(factor, column.channel.order, fittedOrder));
        std::optional<Fit> together = withSimplestReading(observations, start, k, isGeometryExact);
        if (together && isLastColumnGenuine(observations, *together)) {
            return together;
        }
    }
    return std::nullopt;
}

/// Angles show only ratios of lengths. Returns a fit of angles together with the first column of lengths that the same
/// mechanism explains in another size; the same fit if there is none. Where a table over the crank angle leaves ω2
/// open, a derivative only shows the size at the assumed speed. `drive`: the kind of the drive; if it is Uneven,
/// nothing predicts derivatives.
Fit withSizeOfLengths(const Observations &observations, const Fit &fit, Drive::Kind drive, bool isGeometryExact)
{
    Fit start = fit;
    start.unknowns.push_back({Unknown::Kind::A});
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const ObservedColumn &column = observations.columns[k];
        const bool isPredicted = drive != Drive::Kind::Uneven || !column.isDerivative();
        if (column.containsAngles() || column.isConstant() || !isPredicted) {
            continue;
        }
        start.model = fit.model;
        scaleLengths(start.model.mechanism, std::abs(bestScale(observations, fit, fit.model, k)));
        std::optional<Fit> together = withSimplestReading(observations, start, k, isGeometryExact);
        if (together && isLastColumnGenuine(observations, *together)) {
            return *std::move(together);
        }
    }
    return fit;
}

/// Determines ω2 of a table over the crank angle from derivatives whose size the fit predicts at a known speed. If
/// these show a single speed, it becomes an unknown of result.fit. If they allow several, result.speeds are these.
void addSpeedOfTable(FurtherColumns &result, const Observations &observations, double givenSpeed)
{
    Fit &fit = result.fit;
    if (fit.isFree({Unknown::Kind::Omega2}) || showOnlyProductWithSpeed(observations, fit.columns)) {
        return;
    }
    result.speeds = findTableSpeeds(observations, fit, givenSpeed);
    if (result.speeds.size() == 1) { // the derivatives can be used, and improve it
        fit.unknowns.push_back({Unknown::Kind::Omega2});
        fit.model.mechanism.omega2 = result.speeds[0];
    }
}

/// Adds the columns that show what the fit of the geometry leaves open: in a table over the crank angle the speed, and
/// beside angles the size of the mechanism.
void addColumnsOfSpeedAndSize(FurtherColumns &result, const Observations &observations, Drive::Kind drive,
                              double givenSpeed, bool isGeometryExact)
{
    Fit &fit = result.fit;
    if (drive == Drive::Kind::OverAngle) {
        addSpeedOfTable(result, observations, givenSpeed);
    }
    if (observations.containOnlyAngles(fit.columns) && result.speeds.size() < 2) {
        fit = withSizeOfLengths(observations, fit, drive, isGeometryExact);
    }
    const bool isSpeedOpen = drive == Drive::Kind::OverAngle && !fit.isFree({Unknown::Kind::Omega2});
    if (isSpeedOpen && showOnlyProductWithSpeed(observations, fit.columns)) {
        fit = withSpeedOfTwoOrders(observations, fit, isGeometryExact).value_or(fit);
    }
}

} // namespace

FurtherColumns withFurtherColumns(const Observations &observations, const Fit &fit, const Drive &drive,
                                  const Parameters &given)
{
    FurtherColumns result{.fit = drive.kind == Drive::Kind::OverTime ? withSpeedOfVelocities(observations, fit) : fit};
    const bool isGeometryExact = isExact(observations, result.fit);
    addColumnsOfSpeedAndSize(result, observations, drive.kind, given.omega2, isGeometryExact);
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        for (Index k = 0; k < std::ssize(observations.columns); ++k) {
            if (observations.columns[k].channel.order == order && !result.fit.usesColumn(k)) {
                addOrLeaveOut(result, observations, k, drive.kind, isGeometryExact);
            }
        }
    }
    if (drive.kind == Drive::Kind::OverAngle && !observations.containDerivatives(result.fit.columns)) {
        // No derivative was used after all, so that nothing determines the speed.
        std::erase(result.fit.unknowns, Unknown{Unknown::Kind::Omega2});
        result.fit.model.mechanism.omega2 = given.omega2;
    }
    return result;
}

} // namespace slidercrank
