// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/column_scale.h"

#include "core/identification/least_squares.h"
#include "core/identification/residual_test.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

double maxResidualOfFurtherColumn(const Observations &observations, const Fit &fit)
{
    constexpr double kMaxBesideExactColumns =
        1e-3; // fraction of the range: a program may compute derivatives less exactly
    return isExact(observations, fit) ? kMaxBesideExactColumns : kLargestNoise;
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

double bestFactor(const Observations &observations, const Model &model, Index k)
{
    const ObservedColumn &column = observations.columns[k];
    const Values motion = computeMotion(model, observations, {k}).col(0);
    const Eigen::ArrayX<bool> hasBoth = column.values.isFinite() && motion.isFinite();
    Eigen::MatrixXd basis(motion.size(), column.isDerivative() ? 1 : 2);
    basis.col(0) = hasBoth.select(motion, 0.0);
    if (!column.isDerivative()) {
        basis.col(1) = hasBoth.cast<double>(); // the origin
    }
    return fitLinearly(basis, hasBoth.select(column.values, 0.0)).coefficients[0];
}

ColumnScale fitScale(const Observations &observations, const Fit &fit, const Model &model, Index k)
{
    const ObservedColumn &column = observations.columns[k];
    const double factor = bestFactor(observations, model, k);
    Model scaled = model;
    scaled.readings[k] = {factor, 0.0};
    const Fit fitOfColumn = evaluateModel(observations, scaled, {k});
    return {.factor = factor * signOfCoordinate(observations, fit, column.channel.coordinate),
            .isExplained = fitOfColumn.isFinite() &&
                           (isWithinRounding(observations, fitOfColumn, 0) ||
                            fitOfColumn.rms[0] < maxResidualOfFurtherColumn(observations, fit) * column.range),
            .isNearRounding = fitOfColumn.isFinite() && isNearRounding(observations, fitOfColumn, 0)};
}

double usualFactor(const Observations &observations, const Fit &fit, Index k)
{
    const ObservedColumn &column = observations.columns[k];
    const Coordinate coordinate = column.channel.coordinate;
    if (column.channel == kSliderLine) {
        return 1.0; // its value is c, which may be negative: -12 mm are no sign of a negated column
    }
    const bool isSpeedOfCrank = coordinate == Theta2; // constant, but not zero
    if (column.isConstant() && !isSpeedOfCrank) {
        return signOfCoordinate(observations, fit, coordinate); // such a column shows neither sign nor scale
    }
    const double factor = bestFactor(observations, fit.model, k);
    const auto mismatch = [&](double unit) { return std::abs(std::log(std::abs(factor) / unit)); };
    return std::copysign(std::ranges::min(unitFactors(column.channel), {}, mismatch), factor);
}

} // namespace slidercrank
