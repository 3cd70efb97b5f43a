// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/column_scale.h"

#include "core/identification/rounding_test.h"

#include <array>

namespace slidercrank
{

double largestFurtherResidual(bool othersAreExact)
{
    constexpr double kNextToNothing = 1e-3;
    return othersAreExact ? kNextToNothing : kLargestResidual;
}

std::span<const double> unitFactors(Channel channel)
{
    static constexpr std::array kAngles{1.0, kDegreesPerRadian, 1.0 / kDegreesPerRadian};
    static constexpr std::array kLengths{1.0, 10.0, 0.1, 25.4, 1.0 / 25.4, 1000.0, 0.001};
    return isAngle(channel.coordinate) ? std::span<const double>(kAngles) : std::span<const double>(kLengths);
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

ColumnScale scaleOf(const Observations &observations, const Fit &fit, const Model &model, Index k, bool othersAreExact)
{
    const ObservedColumn &column = observations.columns[k];
    const Values motion = motionIn(model, observations, {k}).col(0);
    const Values products = finite(motion * column.values);
    const double factor = products.sum() / column.values.isFinite().select(finite(motion), 0.0).square().sum();
    Model scaled = model;
    scaled.readings[k] = {factor, 0.0};
    const Fit alone = evaluated(observations, scaled, {k});
    const bool isExact = alone.isFinite() && isWithinRounding(observations, alone, 0);
    const bool isSmall = alone.isFinite() && alone.rms[0] < largestFurtherResidual(othersAreExact) * column.range;
    return {factor * signOfCoordinate(observations, fit, column.channel.coordinate), isExact, isExact || isSmall};
}

} // namespace slidercrank
