// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/residual_test.h"

#include "core/comparison/comparison.h"
#include "core/identification/noise.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

Values roundingBounds(const Observations &observations, const Fit &fit, Index indexInFit)
{
    constexpr double kTieFactor = 1.0 + 1e-6; // a value in the middle of two printable ones is not exact in binary
    const ObservedColumn &column = observations.columns[fit.columns[indexInFit]];
    const double shift = fit.model.followsAngle ? std::abs(fit.model.angleFactor) * observations.angle.halfStep
                                                : std::abs(fit.model.mechanism.omega2) * observations.time.halfStep;
    const Values halfSteps = kTieFactor * column.halfSteps;
    if (shift == 0.0) { // the abscissa is exact
        return halfSteps;
    }
    Values motion = Values::Zero(column.values.size()); // during half a rounding step of the abscissa
    for (const double side : {-shift, shift}) {
        Model shifted = fit.model;
        shifted.mechanism.theta20 += side;
        const Values residuals = column.values - predictValues(shifted, observations, {fit.columns[indexInFit]}).col(0);
        motion = motion.max(gapsAsZeros((residuals - fit.residuals.col(indexInFit)).abs()));
    }
    return halfSteps + motion;
}

double columnSize(const Observations &observations, const Fit &fit, Index indexInFit)
{
    const ObservedColumn &column = observations.columns[fit.columns[indexInFit]];
    return column.channel == kSliderLine ? 2.0 * fit.model.mechanism.a : column.range;
}

bool isWithinRounding(const Observations &observations, const Fit &fit, Index indexInFit)
{
    const ObservedColumn &column = observations.columns[fit.columns[indexInFit]];
    Values bound = roundingBounds(observations, fit, indexInFit);
    // Each bound grows by the error of the fitted mechanism, but at most by the bound of the least exact value (the
    // largest motion during half a step of the abscissa, and the largest half step), because a fit of many values is at
    // least as exact as that value.
    const double largestBound = (bound - column.halfSteps).maxCoeff() + column.halfSteps.maxCoeff();
    bound += std::min(largestBound, fit.fittedMechanism().errorOf(fit.rms[indexInFit]));
    const Values errors = gapsAsZeros(fit.residuals.col(indexInFit)).abs();
    const double within = fit.counts[indexInFit] - static_cast<double>((errors > bound).count());
    return 100.0 * within >= static_cast<double>(kMinPercentWithinBound) * fit.counts[indexInFit] &&
           (errors <= kMaxBoundsToAgree * bound).all() &&
           (errors - bound).maxCoeff() <= kMaxExcessToAgree * 0.5 * column.range;
}

bool isNearRounding(const Observations &observations, const Fit &fit, Index indexInFit)
{
    return isWithinRounding(observations, fit, indexInFit) ||
           fit.rms[indexInFit] <
               kMaxResidualInBounds * std::sqrt(roundingBounds(observations, fit, indexInFit).square().mean());
}

bool isExplained(const Observations &observations, const Fit &fit, Index indexInFit)
{
    const double largest =
        changeSignLikeNoise(fit.residuals.col(indexInFit)) ? kLargestNoise : kLargestSystematicResidual;
    return fit.rms[indexInFit] < largest * columnSize(observations, fit, indexInFit) ||
           isWithinRounding(observations, fit, indexInFit);
}

bool isExact(const Observations &observations, const Fit &fit)
{
    return fit.isFinite() && std::ranges::all_of(fit.indicesInFit(), [&](Index indexInFit) {
               return isWithinRounding(observations, fit, indexInFit);
           });
}

bool explainsAsWell(const Observations &observations, const Fit &fit, const Fit &best)
{
    if (!fit.isFinite()) {
        return false;
    }
    if (isExact(observations, fit)) {
        return true;
    }
    double growth = 0.0;
    for (const Index indexInFit : best.indicesInFit()) {
        growth += (columnMisfit(observations, fit, indexInFit) - columnMisfit(observations, best, indexInFit)) /
                  dependence(best.residuals.col(indexInFit));
    }
    return growth < kMaxMisfitIncrease;
}

bool isSystematic(const Observations &observations, const Fit &fit)
{
    return std::ranges::any_of(fit.indicesInFit(), [&](Index indexInFit) {
        const bool isLikeNoise = changeSignLikeNoise(fit.residuals.col(indexInFit)) &&
                                 !observations.columns[fit.columns[indexInFit]].isInterpolated;
        return !isLikeNoise && !isWithinRounding(observations, fit, indexInFit);
    });
}

} // namespace slidercrank
