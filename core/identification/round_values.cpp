// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/round_values.h"

#include "core/comparison/comparison.h"
#include "core/identification/noise.h"
#include "core/identification/residual_test.h"
#include "core/identification/round_number.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

/// Rounds a value of an unknown in the units in which a person may have chosen it (see findRoundNumber()). Origins are
/// not rounded.
RoundNumber roundInUsualUnits(Unknown unknown, double value, double standardError, double lengthUnit)
{
    constexpr double kDegree = 1.0 / kDegreesPerRadian;
    constexpr double kTurnPerMinute = kTurn / 60.0;
    if (unknown.isOrigin()) { // measured, and not chosen
        return {value};
    }
    switch (*unknown.parameter) {
    case Parameter::A:
    case Parameter::B:
    case Parameter::C: return roundLength(value, standardError, lengthUnit);
    case Parameter::Omega2: return findRoundNumber(value, standardError, std::array{1.0, kDegree, kTurnPerMinute});
    case Parameter::Theta20: break;
    }
    return findRoundNumber(value, standardError, std::array{kDegree, 1.0});
}

/// An unknown of the last fit.
struct EstimatedUnknown {
    Unknown unknown;
    std::optional<Parameter> parameter{}; ///< the parameter whose value at t = 0 of the file it is; nullopt for origins
    double size = 1.0;                    ///< parameterSize(); 1 mm or 1 rad for origins
    bool isFixed = false;                 ///< its value no longer changes, see fixUnknown()
};

/// What is known about the unknowns of the last fit: their values, normally distributed with a covariance.
struct Estimate {
    std::vector<EstimatedUnknown> unknowns;
    Eigen::VectorXd values;     ///< the value of each unknown
    Eigen::MatrixXd covariance; ///< covariance of the values
    double lengthUnit = 1.0;    ///< the unit in which lengths are rounded, mm

    /// The standard error of an unknown, at least that of the arithmetic.
    double standardError(Index k) const
    {
        return std::max(std::sqrt(std::max(covariance(k, k), 0.0)), kFitArithmeticError * unknowns[k].size);
    }
};

/// Makes an estimate in which no unknown is fixed yet. `unrounded`: the parameters of the last fit at t = 0 of the
/// file. θ20 of a model that follows the angle in the file is the origin of that angle, so that it is an origin here
/// and no parameter.
Estimate makeEstimate(const LastFit &lastFit, const Parameters &unrounded)
{
    const Model &model = lastFit.fit.model;
    Estimate estimate{.unknowns = {},
                      .values = Eigen::VectorXd(lastFit.covariance.rows()),
                      .covariance = lastFit.covariance,
                      .lengthUnit = lastFit.observations.lengthUnit};
    for (const Unknown unknown : lastFit.fit.unknowns) {
        const Index k = std::ssize(estimate.unknowns);
        const bool isOriginOfAngle = model.followsAngle && unknown.parameter == Parameter::Theta20;
        if (unknown.parameter && !isOriginOfAngle) {
            const Parameter parameter = *unknown.parameter;
            estimate.values[k] = valueOf(unrounded, parameter);
            estimate.unknowns.push_back({unknown, parameter, parameterSize(parameter, unrounded)});
        } else {
            estimate.values[k] = valueOf(model, unknown);
            estimate.unknowns.push_back({unknown});
        }
    }
    return estimate;
}

/// Fixes an unknown at a value. The others change as their covariance with it predicts, and become more certain.
void fixUnknown(Estimate &estimate, Index k, double value)
{
    const double variance = estimate.covariance(k, k);
    if (variance > 0.0) {
        const Eigen::VectorXd influence = estimate.covariance.col(k) / variance;
        estimate.values += influence * (value - estimate.values[k]);
        estimate.covariance -= variance * influence * influence.transpose();
    }
    estimate.values[k] = value;
    estimate.covariance.row(k).setZero();
    estimate.covariance.col(k).setZero();
    estimate.unknowns[k].isFixed = true;
}

/// The unknowns that are not fixed, the most certain first.
Indices notFixedUnknowns(const Estimate &estimate)
{
    Indices notFixed;
    for (Index k = 0; k < estimate.values.size(); ++k) {
        if (!estimate.unknowns[k].isFixed) {
            notFixed.push_back(k);
        }
    }
    std::ranges::sort(notFixed, {}, [&](Index k) { return estimate.standardError(k) / estimate.unknowns[k].size; });
    return notFixed;
}

/// Rounds the current value of an unknown to its current standard error.
RoundNumber roundUnknown(const Estimate &estimate, Index k)
{
    return roundInUsualUnits(estimate.unknowns[k].unknown, estimate.values[k], estimate.standardError(k),
                             estimate.lengthUnit);
}

/// Fixes each unknown for which there is a number that a person may have chosen (RoundNumber::isChosen) at that number.
/// Repeats this as long as it fixes any, because each fixed unknown makes the others more certain.
void fixChosenNumbers(Estimate &estimate)
{
    for (bool isAnyFixed = true; isAnyFixed;) {
        isAnyFixed = false;
        for (const Index k : notFixedUnknowns(estimate)) {
            const RoundNumber number = roundUnknown(estimate, k);
            if (number.isChosen) {
                fixUnknown(estimate, k, number.value);
                isAnyFixed = true;
            }
        }
    }
}

/// Replaces those parameters that an estimate contains by their values in it.
Parameters replaceByEstimate(Parameters parameters, const Estimate &estimate)
{
    for (Index k = 0; k < estimate.values.size(); ++k) {
        if (const std::optional<Parameter> parameter = estimate.unknowns[k].parameter) {
            valueOf(parameters, *parameter) = estimate.values[k];
        }
    }
    return parameters;
}

/// Rounds the parameters of the last fit as if their standard errors were multiplied by `fraction`. The free origins
/// keep their values; then chosen numbers are fixed (fixChosenNumbers()), then every other parameter is rounded to the
/// first digit of its error.
Parameters roundToErrors(const LastFit &lastFit, const Parameters &unrounded, double fraction)
{
    Parameters rounded = unrounded;
    Estimate estimate = makeEstimate(lastFit, unrounded);
    if (lastFit.fit.model.followsAngle) { // ω2 and θ20 are those of the drive, which have errors of their own
        for (const Parameter parameter : {Parameter::Omega2, Parameter::Theta20}) {
            const double error = fraction * lastFit.standardErrors[indexOf(parameter)];
            valueOf(rounded, parameter) =
                roundInUsualUnits(parameter, valueOf(unrounded, parameter), error, estimate.lengthUnit).value;
        }
    }
    estimate.covariance *= fraction * fraction;
    for (const Index k : notFixedUnknowns(estimate)) {
        if (!estimate.unknowns[k].parameter) {
            fixUnknown(estimate, k, estimate.values[k]);
        }
    }
    fixChosenNumbers(estimate);
    // Nobody has chosen the other numbers. Their digits below the standard errors mean nothing.
    for (const Index k : notFixedUnknowns(estimate)) {
        fixUnknown(estimate, k, roundUnknown(estimate, k).value);
    }
    return replaceByEstimate(rounded, estimate);
}

/// The model with other parameters at t = 0 of the file. If it follows the angle in the file, its θ20 is the origin of
/// that angle, and does not change. In a run-up, its ω2 is the speed in the middle of the file, and does not change.
Model withParameters(Model model, const Parameters &parameters, const Observations &observations)
{
    Parameters mechanism = parameters;
    if (model.followsAngle) {
        mechanism.theta20 = model.mechanism.theta20;
    } else {
        mechanism.theta20 += parameters.omega2 * observations.timeOrigin;
    }
    const bool isRunUp = model.alpha2 != 0.0;
    if (isRunUp) {
        mechanism.omega2 = model.mechanism.omega2;
    }
    model.mechanism = mechanism;
    return model;
}

/// Whether 95 % of the residuals of fit.columns[indexInFit] are within the bounds of rounding. Unlike
/// isWithinRounding(), does not enlarge the bounds by the error of the fit, because rounded parameters are no fit.
bool areNearlyAllWithinRounding(const Observations &observations, const Fit &fit, Index indexInFit)
{
    const Values errors = gapsAsZeros(fit.residuals.col(indexInFit)).abs();
    const auto beyond = static_cast<double>((errors > roundingBounds(observations, fit, indexInFit)).count());
    return 100.0 * (fit.counts[indexInFit] - beyond) >=
           static_cast<double>(kMinPercentWithinBound) * fit.counts[indexInFit];
}

/// Whether rounded parameters still explain what the fit from which they were rounded explains: each column that was
/// nearly all within rounding still is, and the misfit is higher by less than a limit. (explainsAsWell(), which
/// compares two fits, allows more.)
bool areStillExplained(const Observations &observations, const Fit &rounded, const Fit &fit)
{
    // The misfit of the true values of five parameters is higher than that of the fit by 5 on average, and seldom
    // by 10.
    constexpr double kMaxGrowth = 10.0;
    const auto isStillWithinRounding = [&](Index indexInFit) {
        return !areNearlyAllWithinRounding(observations, fit, indexInFit) ||
               areNearlyAllWithinRounding(observations, rounded, indexInFit);
    };
    return rounded.misfit - fit.misfit < kMaxGrowth && std::ranges::all_of(fit.indicesInFit(), isStillWithinRounding);
}

} // namespace

Parameters roundedParameters(const LastFit &lastFit, const Parameters &unrounded)
{
    // Fractions of the standard errors, tried in this order: with larger ones, the rounded values together may change
    // the motion too much.
    constexpr std::array kFractions{1.0, 0.1, 0.01};
    const Observations &observations = lastFit.observations;
    const Fit &fit = lastFit.fit;
    for (const double fraction : kFractions) {
        const Parameters rounded = roundToErrors(lastFit, unrounded, fraction);
        const Model model = withParameters(fit.model, rounded, observations);
        if (!findFault(rounded) &&
            areStillExplained(observations, evaluateModel(observations, model, fit.columns), fit)) {
            return rounded;
        }
    }
    return unrounded;
}

void moveToChosenNumbers(LastFit &lastFit, const Parameters &unrounded)
{
    Fit &fit = lastFit.fit;
    Estimate estimate = makeEstimate(lastFit, unrounded);
    const auto isParameter = [](const EstimatedUnknown &estimated) { return estimated.parameter.has_value(); };
    if (std::ranges::all_of(estimate.unknowns, isParameter)) {
        return;
    }
    fixChosenNumbers(estimate);
    Model model = withParameters(fit.model, replaceByEstimate(unrounded, estimate), lastFit.observations);
    for (Index k = 0; k < estimate.values.size(); ++k) {
        if (!estimate.unknowns[k].parameter) {
            valueOf(model, estimate.unknowns[k].unknown) = estimate.values[k];
        }
    }
    const Fit moved = evaluateModel(lastFit.observations, std::move(model), fit.columns);
    if (areStillExplained(lastFit.observations, moved, fit)) {
        fit.replaceModel(moved);
    }
}

} // namespace slidercrank
