// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/column_scale.h"

#include "core/identification/residual_test.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

/// The factor with which a motion fits values best, by least squares. Gaps of the values do not count.
double bestFactor(const Values &motion, const Values &values)
{
    const Values counted = values.isFinite().select(gapsAsZeros(motion), 0.0);
    return (counted * gapsAsZeros(values)).sum() / counted.square().sum();
}

/// The factor with which a motion fits values of any origin best, by least squares.
double bestSlope(const Values &motion, const Values &values)
{
    const Values counted = values.isFinite().select(motion, kNone);
    const double count = static_cast<double>(counted.isFinite().count());
    const double meanMotion = gapsAsZeros(counted).sum() / count;
    const double meanValue = gapsAsZeros(counted.isFinite().select(values, kNone)).sum() / count;
    return bestFactor(motion - meanMotion, values - meanValue);
}

} // namespace

double largestFurtherResidual(bool othersAreExact)
{
    constexpr double kLargestBesideExactColumns = 1e-3; // of the range: a program may compute derivatives less exactly
    return othersAreExact ? kLargestBesideExactColumns : kLargestNoise;
}

std::span<const double> unitFactors(Channel channel)
{
    static constexpr std::array kLengthFactors = withInverses(kLengthUnits);
    return isAngle(channel.coordinate) ? std::span<const double>(kAngleFactors)
                                       : std::span<const double>(kLengthFactors);
}

double signOfCoordinate(const Observations &observations, const Fit &fit, Coordinate coordinate)
{
    for (const Index k : fit.columns) {
        if (observations.columns[k].channel.coordinate == coordinate) {
            return std::copysign(1.0, fit.model.readings[k].factor);
        }
    }
    return 1.0;
}

double bestScale(const Observations &observations, const Fit &fit, const Model &model, Index k)
{
    const ObservedColumn &column = observations.columns[k];
    const Values motion = computeMotion(model, observations, {k}).col(0);
    const double factor = column.isDerivative() ? bestFactor(motion, column.values) : bestSlope(motion, column.values);
    return factor * signOfCoordinate(observations, fit, column.channel.coordinate);
}

ColumnScale fitScale(const Observations &observations, const Fit &fit, const Model &model, Index k, bool othersAreExact)
{
    const ObservedColumn &column = observations.columns[k];
    const double factor = bestScale(observations, fit, model, k);
    // The scale is relative to this sign, a reading is not.
    const double sign = signOfCoordinate(observations, fit, column.channel.coordinate);
    Model scaled = model;
    scaled.readings[k] = {sign * factor, 0.0};
    const Fit fitOfColumn = evaluateModel(observations, scaled, {k});
    const bool isSmall = fitOfColumn.rms[0] < largestFurtherResidual(othersAreExact) * column.range;
    return {.factor = factor,
            .isExplained = fitOfColumn.isFinite() && (isSmall || isWithinRounding(observations, fitOfColumn, 0)),
            .isNearRounding = fitOfColumn.isFinite() && isNearRounding(observations, fitOfColumn, 0)};
}

double usualFactor(const Observations &observations, const Fit &fit, Index k)
{
    const ObservedColumn &column = observations.columns[k];
    const Coordinate coordinate = column.channel.coordinate;
    const double sign = signOfCoordinate(observations, fit, coordinate);
    if (column.channel == kSliderLine) {
        return 1.0; // -12 mm means c = -12 mm, and not a negated column
    }
    const bool isSpeedOfCrank = coordinate == Theta2; // constant, but not zero
    if (column.isConstant() && !isSpeedOfCrank) {
        return sign; // zeros have neither sign nor scale
    }
    const double factor = sign * bestScale(observations, fit, fit.model, k);
    const auto mismatch = [&](double unit) { return std::abs(std::log(std::abs(factor) / unit)); };
    return std::copysign(std::ranges::min(unitFactors(column.channel), {}, mismatch), factor);
}

} // namespace slidercrank
