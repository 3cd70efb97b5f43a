// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/varying_speed.h"

#include "core/identification/least_squares.h"

#include <cmath>

namespace slidercrank
{

namespace
{

/// The residuals of all columns, or the changes of all predictions, below each other, each divided by the size of the
/// errors of its column. Gaps are 0.
Eigen::VectorXd weightedTogether(const Observations &observations, const Fit &fit, const Eigen::ArrayXXd &values)
{
    Eigen::ArrayXXd weighted = (fit.residuals.isFinite()).select(values, 0.0);
    for (Index place = 0; place < weighted.cols(); ++place) {
        const double variance = observations.columns[fit.columns[place]].variance;
        weighted.col(place) /= std::sqrt(fit.rms[place] * fit.rms[place] + variance);
    }
    return weighted.reshaped();
}

/// The derivatives of the predictions by a number of the model, by central differences. `change`: adds a given amount
/// to that number.
template <class Change>
Eigen::VectorXd derivativeBy(const Observations &observations, const Fit &fit, double step, const Change &change)
{
    Model more = fit.model;
    change(more, step);
    Model less = fit.model;
    change(less, -step);
    const Eigen::ArrayXXd difference =
        predictValues(more, observations, fit.columns) - predictValues(less, observations, fit.columns);
    return weightedTogether(observations, fit, difference / (2.0 * step));
}

} // namespace

ParameterErrors changesByRipple(const LastFit &lastFit)
{
    constexpr double kStep = 1e-6;       // of the numerical derivatives, relative to the size of a number
    constexpr double kMaxFraction = 0.5; // of the residuals that remain if a ripple explains them
    ParameterErrors changes{};
    if (lastFit.fit.model.followsAngle) {
        return changes;
    }
    const Observations observations = selectRows(lastFit.observations, kSearchedRows);
    const Fit fit = evaluateModel(observations, lastFit.fit.model, lastFit.fit.columns);
    const Unknowns &unknowns = lastFit.fit.unknowns;
    const Index count = std::ssize(unknowns);
    Eigen::MatrixXd basis(fit.residuals.size(), count + 2);
    for (Index i = 0; i < count; ++i) {
        const Unknown unknown = unknowns[i];
        const double size = unknown.isParameter() ? parameterSize(toParameter(unknown), fit.model.mechanism)
                                                  : observations.columns[unknown.column].range;
        basis.col(i) = derivativeBy(observations, fit, kStep * size,
                                    [&](Model &model, double step) { valueOf(model, unknown) += step; });
    }
    basis.col(count) =
        derivativeBy(observations, fit, kStep, [](Model &model, double step) { model.ripple.cosine += step; });
    basis.col(count + 1) =
        derivativeBy(observations, fit, kStep, [](Model &model, double step) { model.ripple.sine += step; });
    const Eigen::VectorXd residuals = weightedTogether(observations, fit, fit.residuals);
    const LinearFit withRipple = fitLinearly(basis, residuals);
    if (withRipple.residuals.matrix().norm() < kMaxFraction * residuals.norm()) {
        for (Index i = 0; i < count; ++i) {
            if (unknowns[i].isParameter()) {
                changes[indexOf(toParameter(unknowns[i]))] = std::abs(withRipple.coefficients[i]);
            }
        }
    }
    return changes;
}

} // namespace slidercrank
