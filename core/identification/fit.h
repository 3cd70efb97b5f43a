// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Fits a model to columns of a file. Every step of the identification uses this one fit, with other unknowns and other
// columns. It minimizes the misfit
//
//     S = Σ over the columns: n ln( RSS/n + mean of step²/12 )
//
// where n is the number of values and RSS the sum of their squared residuals (value - prediction). S is minus twice the
// logarithm of the likelihood of independent errors, whose size is unknown in each column but not below the rounding.
// The gradient of S is that of a weighted sum of squared residuals, in which the weight of a column is
// 1 / (RSS/n + mean of step²/12). The second derivatives of this sum with fixed weights approximate those of S. A
// constant column repeats one rounding error n times. Therefore it contributes to S like a single value: RSS/n divided
// by the mean of step²/12.

#include "core/comparison/comparison.h"
#include "core/identification/model.h"

#include <array>
#include <vector>

namespace slidercrank
{

/// A number of the model that a fit may change.
struct Unknown {
    enum class Kind {
        A,
        B,
        C,
        Omega2,
        CrankAngle, ///< θ20 of the model
        Origin      ///< of a column
    };
    Kind kind = Kind::A;
    Index column = 0; ///< of an Origin

    bool isParameter() const { return kind != Kind::Origin; }
    friend bool operator==(const Unknown &, const Unknown &) = default;
};
using Unknowns = std::vector<Unknown>;

double &valueOf(Model &model, Unknown unknown);
double valueOf(const Model &model, Unknown unknown);

/// An error of each parameter, at indexOf(Parameter), in mm, rad and s.
using ParameterErrors = std::array<double, kParameterCount>;

inline constexpr std::array kLengths{Parameter::A, Parameter::B, Parameter::C};

// The parameters are the first kinds of unknowns, in the same order.
static_assert(static_cast<std::size_t>(Unknown::Kind::A) == indexOf(Parameter::A) &&
              static_cast<std::size_t>(Unknown::Kind::B) == indexOf(Parameter::B) &&
              static_cast<std::size_t>(Unknown::Kind::C) == indexOf(Parameter::C) &&
              static_cast<std::size_t>(Unknown::Kind::Omega2) == indexOf(Parameter::Omega2) &&
              static_cast<std::size_t>(Unknown::Kind::CrankAngle) == indexOf(Parameter::Theta20) &&
              static_cast<std::size_t>(Unknown::Kind::Origin) == kParameterCount);
inline Unknown unknownOf(Parameter parameter)
{
    return {static_cast<Unknown::Kind>(indexOf(parameter))};
}
/// Requires unknown.isParameter().
inline Parameter parameterOf(Unknown unknown)
{
    return static_cast<Parameter>(unknown.kind);
}

/// Two fits whose misfits differ by less are equally good: the ratio of their likelihoods is less than exp(10).
inline constexpr double kSameMisfit = 20.0;

struct Fit {
    Model model;
    Indices columns;
    Unknowns unknowns{};          ///< the numbers of the model that were fitted
    Eigen::ArrayXXd residuals{};  ///< value - prediction, one column each; NaN in gaps
    std::vector<double> rms{};    ///< of the residuals of each column
    std::vector<double> counts{}; ///< number of values of each column
    double misfit = kInfinity;    ///< S; infinite if the mechanism cannot be assembled in a row that has values
    Eigen::VectorXd gradient{};   ///< first derivatives of S by the unknowns
    Eigen::MatrixXd curvature{};  ///< second derivatives of S by the unknowns
    int iterations = 0;

    bool isFinite() const { return std::isfinite(misfit); }
    bool uses(Index column) const;
    bool changes(Unknown unknown) const;
    Index positionOf(Unknown unknown) const; ///< in `unknowns`; their number if the fit does not change it
    double valueCount() const;               ///< of all columns

    /// Takes the model of another fit of the same columns, with its residuals. Unknowns, gradient and curvature remain.
    void takeModelOf(const Fit &other);

    /// How the mechanism was fitted, for a comparison. The number of values is the average of the columns and not that
    /// of all columns together, because one column may determine all unknowns.
    FittedMechanism fittedMechanism() const
    {
        return {.unknowns = unknowns.size(), .values = valueCount() / static_cast<double>(columns.size())};
    }
};

/// Computes residuals and misfit of a model without changing it.
Fit evaluated(const Observations &observations, Model model, Indices columns);

/// Minimizes the misfit from a start. The result is not finite if the mechanism of the start cannot be assembled, or if
/// the observations request a stop.
Fit refined(const Observations &observations, Model start, Indices columns, Unknowns unknowns,
            int iterationLimit = 200);

/// Whether the crank makes less than a turn, so that nothing returns to where it was: the motions of many mechanisms,
/// with other origins, are nearly equal on an arc.
bool isShortArc(const Observations &observations, const Model &model);

/// The dependence of the residuals (noise.h) in the column in which it is largest.
double dependence(const Fit &fit);

/// Whether the residuals of every column change their sign like independent errors.
bool isNoise(const Fit &fit);

/// The step from the unknowns of a fit to the minimum, as gradient and curvature predict it. It is large if the search
/// has ended in a long and curved valley of the misfit, and 0 for unknowns that the columns do not determine.
Eigen::VectorXd stepToMinimum(const Fit &fit);

/// The error of the worst determined combination of the unknowns, divided by that of the best determined one. The
/// unknowns are scaled so that the second derivative of S by each is 1.
double conditionNumber(const Fit &fit);

/// The covariance matrix of the unknowns; very large variances for unknowns that the columns do not determine.
Eigen::MatrixXd covarianceOf(const Fit &fit);

} // namespace slidercrank
