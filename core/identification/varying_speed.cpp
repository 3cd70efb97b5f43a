// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/varying_speed.h"

#include "core/identification/least_squares.h"

#include <cmath>

namespace slidercrank
{

namespace
{

/// The elements of `values`, which has the shape of fit.residuals, as one column. Each is divided by the size of the
/// errors of its column in the file, so that all columns weigh the same. Gaps are 0.
Eigen::VectorXd weightedColumn(const Observations &observations, const Fit &fit, const Eigen::ArrayXXd &values)
{
    Eigen::ArrayXXd weighted = fit.residuals.isFinite().select(values, 0.0);
    for (Index indexInFit = 0; indexInFit < weighted.cols(); ++indexInFit) {
        const double variance = observations.columns[fit.columns[indexInFit]].variance;
        weighted.col(indexInFit) /= std::sqrt(fit.rms[indexInFit] * fit.rms[indexInFit] + variance);
    }
    return weighted.reshaped();
}

/// The derivative of all predictions by a number of the model, in the form of weightedColumn(), by central differences.
/// `add`: adds an amount to this number in a model. `size`: its order of magnitude.
template <class Add>
Eigen::VectorXd derivativeOfPredictions(const Observations &observations, const Fit &fit, double size, const Add &add)
{
    constexpr double kRelativeStep = 1e-6;
    const double step = kRelativeStep * size;
    Model increased = fit.model;
    add(increased, step);
    Model decreased = fit.model;
    add(decreased, -step);
    const Eigen::ArrayXXd difference =
        predictValues(increased, observations, fit.columns) - predictValues(decreased, observations, fit.columns);
    return weightedColumn(observations, fit, difference / (2.0 * step));
}

/// The derivatives of the predictions by some unknowns: a column for each of them, in their order.
Eigen::MatrixXd derivativesByUnknowns(const Observations &observations, const Fit &fit, const Unknowns &unknowns)
{
    Eigen::MatrixXd derivatives(fit.residuals.size(), std::ssize(unknowns));
    for (Index i = 0; i < std::ssize(unknowns); ++i) {
        const Unknown unknown = unknowns[i];
        const double size = unknown.isOrigin() ? observations.columns[unknown.column].range
                                               : parameterSize(*unknown.parameter, fit.model.mechanism);
        derivatives.col(i) = derivativeOfPredictions(
            observations, fit, size, [unknown](Model &model, double amount) { valueOf(model, unknown) += amount; });
    }
    return derivatives;
}

/// The derivatives of the predictions by both numbers of a ripple, a column for each.
Eigen::MatrixXd derivativesByRipple(const Observations &observations, const Fit &fit)
{
    constexpr double kSizeOfRipple = 1.0; // rad
    Eigen::MatrixXd derivatives(fit.residuals.size(), 2);
    derivatives << derivativeOfPredictions(observations, fit, kSizeOfRipple,
                                           [](Model &model, double amount) { model.ripple.cosine += amount; }),
        derivativeOfPredictions(observations, fit, kSizeOfRipple,
                                [](Model &model, double amount) { model.ripple.sine += amount; });
    return derivatives;
}

} // namespace

ParameterErrors changesByRipple(const LastFit &lastFit)
{
    constexpr double kMaxRemainingFraction = 0.5; // of the residuals (rms), if a ripple explains them
    ParameterErrors changes{};
    if (lastFit.fit.model.followsAngle) {
        return changes;
    }
    const Observations observations = selectRows(lastFit.observations, kSearchedRows);
    const Fit fit = evaluateModel(observations, lastFit.fit.model, lastFit.fit.columns);
    const Unknowns &unknowns = lastFit.fit.unknowns;
    const Eigen::MatrixXd byUnknowns = derivativesByUnknowns(observations, fit, unknowns);
    const Eigen::MatrixXd byRipple = derivativesByRipple(observations, fit);
    Eigen::MatrixXd basis(byUnknowns.rows(), byUnknowns.cols() + byRipple.cols());
    basis << byUnknowns, byRipple;
    const Eigen::VectorXd residuals = weightedColumn(observations, fit, fit.residuals);
    const LinearFit withRipple = fitLinearly(basis, residuals);
    if (withRipple.residuals.matrix().norm() >= kMaxRemainingFraction * residuals.norm()) {
        return changes;
    }
    const Eigen::VectorXd changesOfUnknowns = withRipple.coefficients.head(std::ssize(unknowns));
    for (Index i = 0; i < std::ssize(unknowns); ++i) {
        if (const std::optional<Parameter> parameter = unknowns[i].parameter) {
            changes[indexOf(*parameter)] = std::abs(changesOfUnknowns[i]);
        }
    }
    return changes;
}

} // namespace slidercrank
