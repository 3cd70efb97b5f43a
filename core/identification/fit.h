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
// 1 / (RSS/n + mean of step²/12). The second derivatives of S are approximated by those of this sum with fixed weights
// and predictions that are linear in the unknowns (the method of Gauss and Newton).
//
// A constant column (ObservedColumn::isConstant()) repeats one rounding error n times. Therefore it contributes to S
// like a single value whose error is known: RSS/n divided by the mean of step²/12.

#include "core/comparison/comparison.h"
#include "core/identification/minimizer.h"
#include "core/identification/model.h"

#include <array>
#include <optional>
#include <vector>

namespace slidercrank
{

/// A number of the model that may be free in a fit: a parameter of its mechanism, or the origin of a column.
struct Unknown {
    std::optional<Parameter> parameter; ///< nullopt for an origin
    Index column = 0;                   ///< the column of the observations whose origin it is; 0 for a parameter

    /// Implicit, so that unknowns can be listed as {Parameter::A, Parameter::B}.
    Unknown(Parameter parameterOfModel)
        : parameter(parameterOfModel)
    {
    }
    explicit Unknown(Index columnWithOrigin)
        : column(columnWithOrigin)
    {
    }
    bool isOrigin() const { return !parameter; }
    friend bool operator==(const Unknown &, const Unknown &) = default;
};
using Unknowns = std::vector<Unknown>;

/// The origin of a column of the observations.
inline Unknown originOf(Index column)
{
    return Unknown(column);
}

/// The value of an unknown in a model: a length in mm, an angle in rad, a speed in rad/s, the origin of a column.
double &valueOf(Model &model, Unknown unknown);
double valueOf(const Model &model, Unknown unknown);

/// An error of each parameter, at indexOf(Parameter), in mm, rad and s.
using ParameterErrors = std::array<double, kParameterCount>;

/// The largest relative difference of a parameter from the same one as a person has typed it, with few digits.
inline constexpr double kTypedDifference = 2e-3;

/// Difference (mm, rad or °) of two origins that are equal: far above rounding errors, far below an origin that
/// matters.
inline constexpr double kOriginTolerance = 1e-6;

inline constexpr std::array kLengths{Parameter::A, Parameter::B, Parameter::C};

/// The size with which an error of a parameter is compared, in mm, rad and s: the parameter itself, but at least the
/// crank for an offset, and a radian for an angle.
double parameterSize(Parameter parameter, const Parameters &parameters);

/// Rounding error of the computation of a fitted parameter, relative to its size.
inline constexpr double kFitArithmeticError = 1e-13;

/// A fitted model. Where a function has a parameter `indexInFit`, it is about the column fit.columns[indexInFit] and
/// its residuals fit.residuals.col(indexInFit); a parameter `k` is the index of a column of the observations.
struct Fit {
    Model model;
    Indices columns;     ///< those of the observations to which the model was fitted
    Unknowns unknowns{}; ///< the numbers of the model that were free
    Eigen::ArrayXXd
        residuals{};           ///< value - prediction: a row for each row, a column for each of `columns`; NaN in gaps
    std::vector<double> rms{}; ///< root mean square of the residuals, for each of `columns`
    std::vector<double> counts{}; ///< number of values, for each of `columns`
    double misfit = kInfinity;    ///< S; infinite if the mechanism cannot be assembled in a row that has values
    Eigen::VectorXd gradient{};   ///< first derivatives of S by the unknowns
    Eigen::MatrixXd curvature{};  ///< approximate second derivatives of S by the unknowns
    int iterations = 0;           ///< number of steps that the search for the minimum has tried

    bool isFinite() const { return std::isfinite(misfit); }
    bool usesColumn(Index column) const;
    bool isFree(Unknown unknown) const;
    Index indexOf(Unknown unknown) const; ///< its index in `unknowns`; unknowns.size() if it is not free
    double valueCount() const;            ///< number of values in all columns
    Indices indicesInFit() const; ///< 0, 1, …: the indices of the columns in the fit; none if there are no residuals

    /// The unknowns and those of `more` that are not among them.
    Unknowns unknownsWith(const Unknowns &more) const;

    /// Replaces the model, its residuals, their rms and the misfit by those of another fit of the same columns. All
    /// other members remain, such as the unknowns and the curvature.
    void replaceModel(const Fit &other);

    /// How the mechanism was fitted, for a comparison. The number of values is the average of the columns and not that
    /// of all columns together, because one column may determine all unknowns.
    FittedMechanism fittedMechanism() const
    {
        return {.unknowns = unknowns.size(), .values = valueCount() / static_cast<double>(columns.size())};
    }
};

/// Computes the residuals and the misfit of a model, without unknowns.
Fit evaluateModel(const Observations &observations, Model model, Indices columns);

/// The part of the misfit that fit.columns[indexInFit] contributes.
double columnMisfit(const Observations &observations, const Fit &fit, Index indexInFit);

/// Changes the unknowns of a model so that the misfit in `columns` is least, and returns this fit. The search starts at
/// the values that the unknowns have in `start`, and tries at most `iterationLimit` steps. The fit is not finite if the
/// mechanism of the start cannot be assembled, or if the observations request a stop.
Fit fitModel(const Observations &observations, Model start, Indices columns, Unknowns unknowns,
             int iterationLimit = MinimizerOptions{}.iterationLimit);

/// Whether the crank makes less than a turn (0.9 turns), so that nothing returns to where it was: the motions of many
/// mechanisms, with suitable origins, are nearly equal on an arc.
bool isShortArc(const Observations &observations, const Model &model);

/// The largest value of dependence() (noise.h) among the columns of the fit; at least 1.
double dependence(const Fit &fit);

/// The step from the unknowns of a fit to the minimum of the misfit, as its gradient and curvature predict it. The step
/// is long if the search has ended in a long and curved valley of the misfit. 0 for an unknown that changes no column.
Eigen::VectorXd stepToMinimum(const Fit &fit);

/// The error of the worst determined combination of the unknowns, divided by that of the best determined one. The
/// unknowns are scaled so that the diagonal elements of the curvature are 1.
double conditionNumber(const Fit &fit);

/// The covariance matrix of the unknowns if the residuals are independent. Unknowns that the columns do not determine
/// have very large variances.
Eigen::MatrixXd computeCovariance(const Fit &fit);

/// The standard error of an unknown if the residuals are independent; 0 if it is not free, because it is exact then.
double standardErrorOrZero(const Fit &fit, Unknown unknown);

} // namespace slidercrank
