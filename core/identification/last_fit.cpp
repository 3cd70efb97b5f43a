// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/last_fit.h"

#include "core/identification/residual_test.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

/// For each value, the larger one of its differences from the value before and the value after it.
Values largestChangeToNeighbours(const Values &values)
{
    const Index pairs = values.size() - 1;
    const Values changes = (values.tail(pairs) - values.head(pairs)).abs();
    Values largest = Values::Zero(values.size());
    largest.head(pairs) = changes;
    largest.tail(pairs) = largest.tail(pairs).max(changes);
    return largest;
}

/// Which rows have an outlier in fit.columns[indexInFit], see fitAllRows().
Eigen::ArrayX<bool> findOutliers(const Observations &observations, const Fit &fit, Index indexInFit)
{
    constexpr double kMaxDeviations = 8.0;         // robust standard deviations: noise does not reach them in any file
    constexpr double kDeviationPerMedian = 1.4826; // standard deviation of noise over the median of its magnitudes
    constexpr double kMaxLateness = 0.2;           // intervals between rows by which a row may be late or early
    const ObservedColumn &column = observations.columns[fit.columns[indexInFit]];
    const Values residuals = fit.residuals.col(indexInFit);
    const Values errors = residuals.abs();
    const double limit = kMaxDeviations * std::max(kDeviationPerMedian * median(errors), std::sqrt(column.variance));
    // Residuals from row to row jump at outliers. Systematic residuals may be as large, but rise and fall slowly.
    const Index pairs = residuals.size() - 1;
    if (!(gapsAsZeros(residuals.tail(pairs) - residuals.head(pairs)).abs() > limit).any()) {
        return Eigen::ArrayX<bool>::Constant(residuals.size(), false);
    }
    const Values predictions = predictValues(fit.model, observations, {fit.columns[indexInFit]}).col(0);
    const Values harmless = (kMaxResidualInBounds * roundingBounds(observations, fit, indexInFit))
                                .max(kMaxLateness * largestChangeToNeighbours(predictions));
    return errors > limit && errors > harmless;
}

/// The rows with an outlier in any column of the fit; none if they are too many.
Indices findRowsWithOutliers(const Observations &observations, const Fit &fit)
{
    Eigen::ArrayX<bool> hasOutlier = Eigen::ArrayX<bool>::Constant(observations.size(), false);
    for (const Index indexInFit : fit.indicesInFit()) {
        hasOutlier = hasOutlier || findOutliers(observations, fit, indexInFit);
    }
    Indices rows;
    for (Index row = 0; row < hasOutlier.size(); ++row) {
        if (hasOutlier[row]) {
            rows.push_back(row);
        }
    }
    const bool areTooMany =
        static_cast<double>(rows.size()) > kMaxOutlierFraction * static_cast<double>(hasOutlier.size());
    return areTooMany ? Indices() : rows;
}

/// The lowest order (position, velocity or acceleration) of the lengths that a fit uses; Position if there are none.
Order lowestOrderOfLengths(const Observations &observations, const Fit &fit)
{
    Order lowest = Order::Acceleration;
    bool containsLengths = false;
    for (const Index k : fit.columns) {
        if (!observations.columns[k].containsAngles()) {
            lowest = std::min(lowest, observations.columns[k].channel.order);
            containsLengths = true;
        }
    }
    return containsLengths ? lowest : Order::Position;
}

/// The standard errors because of rounded time stamps, whose start and duration may be anywhere within their margins:
/// those of the speed and the angle of the crank, and of the lengths if n-th derivatives determine them, which are
/// proportional to a ω2ⁿ. All are 0 if the model follows the angle in the file.
ParameterErrors errorsOfClock(const Observations &observations, const Fit &fit)
{
    ParameterErrors errors{};
    if (!fit.model.followsAngle) {
        const Parameters &m = fit.model.mechanism;
        const double speed = std::abs(m.omega2) / std::numbers::sqrt3; // √3: of an even distribution
        errors[indexOf(Parameter::Theta20)] = speed * observations.time.startMargin;
        errors[indexOf(Parameter::Omega2)] = speed * observations.time.durationMargin / observations.span();
        const double relativeError = errors[indexOf(Parameter::Omega2)] / std::abs(m.omega2);
        for (const Parameter length : kLengths) {
            const double order = static_cast<double>(lowestOrderOfLengths(observations, fit));
            errors[indexOf(length)] = order * relativeError * std::abs(valueOf(m, length));
        }
    }
    return errors;
}

/// Computes the covariance of the unknowns and the standard errors of the parameters at t = 0 of the file. Two more
/// independent errors are added to those of the fit: `possibleErrors`, and the step to the minimum that the search did
/// not make if it ended early. The standard errors also contain errorsOfClock(), which the covariance does not contain,
/// because these change no residual.
void computeErrors(LastFit &result, const ParameterErrors &possibleErrors)
{
    const ParameterErrors clockErrors = errorsOfClock(result.observations, result.fit);
    const Fit &fit = result.fit;
    Eigen::MatrixXd &covariance = result.covariance;
    covariance = result.dependence * computeCovariance(fit);
    Eigen::VectorXd step = stepToMinimum(fit);
    if (!fit.model.followsAngle && fit.isFree(Parameter::Omega2) && fit.isFree(Parameter::Theta20)) {
        // The unknown θ20 is the angle in the middle of the file. At t = 0 of the file, the angle is θ20 - ω2
        // timeOrigin.
        const Index angle = fit.indexOf(Parameter::Theta20);
        const Index speed = fit.indexOf(Parameter::Omega2);
        covariance.row(angle) -= result.observations.timeOrigin * covariance.row(speed);
        covariance.col(angle) -= result.observations.timeOrigin * covariance.col(speed);
        step[angle] -= result.observations.timeOrigin * step[speed];
    }
    covariance.diagonal() += step.cwiseAbs2();
    for (Index k = 0; k < std::ssize(fit.unknowns); ++k) {
        if (const std::optional<Parameter> parameter = fit.unknowns[k].parameter) {
            const std::size_t i = indexOf(*parameter);
            covariance(k, k) += possibleErrors[i] * possibleErrors[i];
            result.standardErrors[i] = std::hypot(std::sqrt(covariance(k, k)), clockErrors[i]);
        }
    }
}

} // namespace

double LastFit::standardErrorOf(Unknown unknown) const
{
    const Index k = fit.indexOf(unknown);
    return fit.isFree(unknown) ? std::sqrt(covariance(k, k)) : kNone;
}

void scaleErrors(LastFit &lastFit, Parameter parameter, double factor)
{
    if (lastFit.fit.isFree(parameter)) {
        const Index k = lastFit.fit.indexOf(parameter);
        lastFit.covariance.row(k) *= factor;
        lastFit.covariance.col(k) *= factor;
    }
    lastFit.standardErrors[indexOf(parameter)] *= std::abs(factor);
}

Parameters parametersAtTimeZero(const Model &model, const Observations &observations, const Drive &drive)
{
    Parameters parameters = model.mechanism;
    if (drive.kind == Drive::Kind::RunUp) {
        parameters.theta20 = drive.theta20;
        parameters.omega2 = drive.omega2;
    } else if (drive.kind == Drive::Kind::Uneven) {
        parameters.omega2 = drive.omega2;
    }
    const double t = -observations.timeOrigin;
    if (!model.followsAngle || drive.kind == Drive::Kind::RunUp) {
        parameters.theta20 += parameters.omega2 * t + 0.5 * model.alpha2 * t * t;
        parameters.omega2 += model.alpha2 * t;
    }
    parameters.theta20 = -wrapToPi(-parameters.theta20); // -π becomes π
    for (const Parameter parameter : kAllParameters) {
        double &value = valueOf(parameters, parameter);
        const bool isZero = std::abs(value) <= kFitArithmeticError * parameterSize(parameter, parameters);
        value = isZero ? 0.0 : value;
    }
    return parameters;
}

LastFit fitAllRows(Observations observations, const Fit &start, const ParameterErrors &possibleErrors,
                   const Drive &drive)
{
    Fit fit = evaluateModel(observations, start.model, start.columns);
    Indices excludedRows;
    if (fit.isFinite()) {
        excludedRows = findRowsWithOutliers(observations, fit);
        for (ObservedColumn &column : observations.columns) {
            column.values(excludedRows) = kNone;
        }
        fit = fitModel(observations, fit.model, start.columns, start.unknowns);
    }
    LastFit result{
        .observations = std::move(observations), .fit = std::move(fit), .excludedRows = std::move(excludedRows)};
    if (!result.fit.isFinite()) {
        return result;
    }
    result.isExact = isExact(result.observations, result.fit);
    result.dependence = result.isExact ? 1.0 : dependence(result.fit);
    computeErrors(result, possibleErrors);
    // If the model follows the angle in the file, its unknown θ20 is the origin of that angle. The angle of the crank
    // at t = 0, and the speed of a run-up, are those of the drive.
    if (result.fit.model.followsAngle) {
        result.standardErrors[indexOf(Parameter::Theta20)] = drive.angleErrorAtZero;
    }
    if (drive.kind == Drive::Kind::RunUp) {
        result.standardErrors[indexOf(Parameter::Omega2)] = drive.speedErrorAtZero;
    }
    return result;
}

} // namespace slidercrank
