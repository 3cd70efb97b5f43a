// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/freedoms.h"

#include "core/identification/residual_test.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// The usual value that is nearest to the value of an origin or of the angle of the crank: a multiple of half a turn,
/// or 0 for lengths.
double nearestUsualValue(const Observations &observations, const Model &model, Unknown unknown)
{
    if (!unknown.isOrigin()) {
        return nearestHalfTurns(model.mechanism.theta20, 1.0);
    }
    const ColumnReading &reading = model.readings[unknown.column];
    return observations.columns[unknown.column].containsAngles() ? nearestHalfTurns(reading.origin, reading.factor)
                                                                 : 0.0;
}

/// Repeats a fit with `unknown` fixed at a value. The other unknowns start at the values that their covariance with it
/// predicts.
Fit fitWithFixed(const Observations &observations, const Fit &fit, Unknown unknown, double value)
{
    const Eigen::MatrixXd covariance = computeCovariance(fit);
    const Index position = fit.indexOf(unknown);
    const double change = value - valueOf(fit.model, unknown);
    Model start = fit.model;
    for (Index k = 0; k < std::ssize(fit.unknowns); ++k) {
        valueOf(start, fit.unknowns[k]) += change * covariance(k, position) / covariance(position, position);
    }
    valueOf(start, unknown) = value; // without a rounding error
    Unknowns others = fit.unknowns;
    std::erase(others, unknown);
    return fitModel(observations, std::move(start), fit.columns, others);
}

/// Whether `unknown`, set to `value`, changes the prediction of each column by less than its rounding step (rms).
bool isBelowRounding(const Observations &observations, const Fit &fit, Unknown unknown, double value)
{
    Model moved = fit.model;
    valueOf(moved, unknown) = value;
    const Eigen::ArrayXXd change = evaluateModel(observations, moved, fit.columns).residuals - fit.residuals;
    return std::ranges::all_of(fit.indicesInFit(), [&](Index indexInFit) {
        const double squaredStep = 12.0 * observations.columns[fit.columns[indexInFit]].variance;
        return gapsAsZeros(change.col(indexInFit)).square().sum() <= squaredStep * fit.counts[indexInFit];
    });
}

/// Whether the residuals of every column are rounding, or as small as those that a filter or an interpolation leaves.
bool hasSmallResiduals(const Observations &observations, const Fit &fit)
{
    constexpr double kMaxFraction = 0.01; // of the size of a column (rms): a moving average of R4_x leaves that much
    const auto isSmall = [&](Index indexInFit) {
        return fit.rms[indexInFit] < kMaxFraction * columnSize(observations, fit, indexInFit) ||
               isWithinRounding(observations, fit, indexInFit); // a constant column has the size 0
    };
    return fit.isFinite() && std::ranges::all_of(fit.indicesInFit(), isSmall);
}

/// Whether an origin is so close to its usual value that a filter or an interpolation may have shifted the curve by as
/// much. (The residuals of a filter or an interpolation are not always recognized as systematic. A coarse simulation
/// that was interpolated linearly would otherwise get an origin that nobody has chosen.)
bool isSmallOrigin(const Observations &observations, const Model &model, Unknown unknown, double usual)
{
    constexpr double kMaxOriginFraction = 0.02;           // of the range of the column
    constexpr double kMaxAngle = 1.0 / kDegreesPerRadian; // 1°, of the crank
    const double change = std::abs(valueOf(model, unknown) - usual);
    return change < (unknown.isOrigin() ? kMaxOriginFraction * observations.columns[unknown.column].range : kMaxAngle);
}

/// Repeats a fit with θ3, column k, in its usual unit. `scaleOfC`: the factor by which c is multiplied at the start.
Fit fitInUsualUnit(const Observations &observations, const Fit &fit, Index k, double scaleOfC)
{
    const double unit = std::abs(fit.model.readings[k].factor);
    Model start = fit.model;
    start.readings[k].factor /= unit;
    start.mechanism.b /= unit;
    start.mechanism.c *= scaleOfC;
    return fitModel(observations, std::move(start), fit.columns, fit.unknowns);
}

/// Where sin θ3 ≈ θ3, a different unit of θ3 looks like a different length of the coupler. Returns the fit with θ3 in
/// its usual unit, or the same fit if the file needs the other unit.
Fit withUsualUnits(const Observations &observations, Fit fit)
{
    const Indices columns = fit.columns;
    for (const Index k : columns) {
        const double unit = std::abs(fit.model.readings[k].factor);
        if (!observations.columns[k].containsAngles() || unit == 1.0) {
            continue;
        }
        // θ3 ≈ (c - a sin θ2) / b: if b is divided by `unit`, θ3 is multiplied by it. If the column has its usual
        // origin, its mean c / b is multiplied, too, and c remains. If its origin is free, it takes up the mean; then c
        // is divided as well, so that the mean remains.
        for (const double scaleOfC : {1.0, 1.0 / unit}) {
            Fit next = fitInUsualUnit(observations, fit, k, scaleOfC);
            if (explainsAsWell(observations, next, fit)) {
                fit = std::move(next);
                break;
            }
        }
    }
    return fit;
}

/// With a very long coupler, R4_x ≈ a cos θ2 + constant. With the opposite sign, this is the motion of a crank at
/// π - θ2, for which θ3 is the same. If R4_x is negated in `fit`, fits that crank with the usual sign and returns this
/// fit if rounding explains its residuals; otherwise returns `fit`, as always in a file with θ2, which shows the sense
/// of rotation.
Fit withUsualSign(const Observations &observations, Fit fit)
{
    Model start = fit.model;
    bool isNegated = false;
    for (const Index k : fit.columns) {
        double &factor = start.readings[k].factor;
        if (observations.columns[k].channel.coordinate == R4x && factor < 0.0) {
            factor = -factor;
            isNegated = true;
        }
    }
    if (!isNegated || fit.model.followsAngle) {
        return fit;
    }
    start.mechanism.omega2 = -start.mechanism.omega2;
    start.mechanism.theta20 = kHalfTurn - start.mechanism.theta20;
    Fit next = fitModel(observations, std::move(start), fit.columns, fit.unknowns);
    return isExact(observations, next) ? next : fit;
}

/// Whether the file does not need an origin (for the conditions, see withoutFreedoms()). `freeFit`: the fit in which
/// `origin` is free. `fixedFit`: the fit in which it has its usual value `usual`.
bool isUnneeded(const Observations &observations, const Fit &freeFit, const Fit &fixedFit, Unknown origin, double usual)
{
    if (explainsAsWell(observations, fixedFit, freeFit)) {
        return true;
    }
    const bool mayComeFromFilter =
        isSystematic(observations, freeFit) || isSmallOrigin(observations, freeFit.model, origin, usual);
    return mayComeFromFilter && hasSmallResiduals(observations, fixedFit);
}

/// Whether an origin that is not needed may exist nevertheless: it is no larger than the rounding steps, or the misfit
/// grows without it as for an origin two standard errors away.
bool originMayExist(const Observations &observations, const Fit &freeFit, const Fit &fixedFit, Unknown origin,
                    double usual)
{
    constexpr double kGrowthOfTwoErrors = 4.0; // of the misfit: (two standard errors)²
    return fixedFit.misfit - freeFit.misfit > kGrowthOfTwoErrors ||
           isBelowRounding(observations, freeFit, origin, usual);
}

/// Adds the changes of the parameters from one fit to another to `errors`, as independent errors.
void addPossibleErrors(ParameterErrors &errors, const Fit &freeFit, const Fit &fixedFit)
{
    for (const Unknown unknown : fixedFit.unknowns) {
        if (unknown.parameter) {
            double &error = errors[indexOf(*unknown.parameter)];
            error = std::hypot(error, valueOf(fixedFit.model, unknown) - valueOf(freeFit.model, unknown));
        }
    }
}

/// The origins that are unknowns of a fit, including θ20 of a model that follows the angle in the file.
Unknowns originsAmong(const Fit &fit)
{
    Unknowns origins;
    std::ranges::copy_if(fit.unknowns, std::back_inserter(origins), [&](Unknown unknown) {
        const bool isOriginOfAngle = fit.model.followsAngle && unknown.parameter == Parameter::Theta20;
        return isOriginOfAngle || unknown.isOrigin();
    });
    return origins;
}

/// Repeats a fit with some further origins free. Returns the same fit if all of these are free already, or if the new
/// one is not finite.
Fit withOriginsFree(const Observations &observations, Fit fit, const Unknowns &origins)
{
    const Unknowns unknowns = fit.unknownsWith(origins);
    if (unknowns.size() == fit.unknowns.size()) {
        return fit;
    }
    Fit next = fitModel(observations, fit.model, fit.columns, unknowns);
    return next.isFinite() ? next : fit;
}

} // namespace

Fit withUsualReadings(const Observations &observations, Fit fit)
{
    fit = withUsualSign(observations, withUsualUnits(observations, std::move(fit)));
    if (fit.model.followsAngle) { // the search may have ended whole turns away
        fit.model.mechanism.theta20 = wrapToPi(fit.model.mechanism.theta20);
    }
    return fit;
}

ConstrainedFit withoutFreedoms(const Observations &observations, Fit fit, const ConstrainedFit &earlier)
{
    ConstrainedFit result{.fit = std::move(fit)};
    if (!result.fit.isFinite()) {
        return result;
    }
    if (result.fit.columns == earlier.fit.columns) {
        result.possibleOrigins = earlier.possibleOrigins;
        result.possibleErrors = earlier.possibleErrors;
    } else {
        result.fit = withOriginsFree(observations, std::move(result.fit), earlier.possibleOrigins);
    }
    for (const Unknown origin : originsAmong(result.fit)) {
        const double usual = nearestUsualValue(observations, result.fit.model, origin);
        Fit fixedFit = fitWithFixed(observations, result.fit, origin, usual);
        if (!isUnneeded(observations, result.fit, fixedFit, origin, usual)) {
            continue;
        }
        if (originMayExist(observations, result.fit, fixedFit, origin, usual)) {
            addPossibleErrors(result.possibleErrors, result.fit, fixedFit);
            result.possibleOrigins.push_back(origin);
        }
        result.fit = std::move(fixedFit);
    }
    return result;
}

} // namespace slidercrank
