// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Weighted least-squares fit of one hypothesis by the method of Levenberg and Marquardt (J. Nocedal, S. Wright,
// "Numerical Optimization", 2nd ed., ch. 10.3). The variance of a value is the sum of three: of its own rounding, of
// the abscissa's rounding, and of the noise of its column, which is estimated from the residuals. Free scales and their
// offsets are computed by linear regression in every trial (variable projection), because as ordinary unknowns they
// make a narrow curved valley.

#include "core/identification/hypothesis.h"

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace slidercrank
{

/// A hypothesis that was fitted to the data, or only rated by its score.
struct Fit {
    Hypothesis hypothesis{};                      ///< with the fitted unknowns
    std::vector<double> noiseVariances{};         ///< by column
    std::vector<double> noiseParts{};             ///< by column, relative to its variance; 0 if it does not vary
    std::vector<std::vector<double>> residuals{}; ///< by column and row; NaN where there is no value
    std::vector<std::vector<double>> variances{}; ///< of the residuals
    double valueCount = 0.0;                      ///< number of residuals
    double freeCount = 0.0;                       ///< number of free unknowns
    double chiSquare = 0.0;
    double logVariance = 0.0; ///< Σ ln(V/z²) with the spread z of the column
    double score = kInfinity; ///< lower is better; infinite if there is no fit
    int iterations = 0;

    bool exists() const { return score < kInfinity; }
};

/// Whether a list of fits contains a hypothesis, apart from small differences of its parameters.
bool isKnown(const Hypothesis &hypothesis, const auto &fits)
{
    const auto isSame = [&](const Fit &fit) {
        const Hypothesis &other = fit.hypothesis;
        return other.timeUnit == hypothesis.timeUnit && other.columns == hypothesis.columns &&
               other.abscissaFactor == hypothesis.abscissaFactor && other.isFree == hypothesis.isFree &&
               areNear(middleParameters(other), middleParameters(hypothesis));
    };
    return std::ranges::any_of(fits, isSame);
}

/// Fits the hypothesis in at most `rounds` rounds, each of which estimates the noise anew. The fitted a is positive.
/// The offsets need no start.
Fit fitHypothesis(const Observations &data, Hypothesis hypothesis, int rounds);

/// Computes residuals, variances and noise of a hypothesis without changing its parameters. Returns no fit if the
/// mechanism cannot be assembled in some row.
Fit evaluateHypothesis(const Observations &data, Hypothesis hypothesis);

/// Sets the free scales, and the offsets of the same columns, by linear regression.
void regressScales(const Observations &data, Hypothesis &hypothesis);

inline constexpr int kErrorsOfColumn = 9; ///< the harmonics of the crank angle up to the fourth

/// Jᵀ V⁻¹ J and Jᵀ V⁻¹ r with respect to the unknowns, and then to the errors of each column, which are `kErrors`
/// functions of the row; held unknowns have 1 on the diagonal.
struct NormalEquations {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd gradient;
};
template <int kErrors>
NormalEquations normalEquations(const Observations &data, const Fit &fit, const Eigen::MatrixXd &errors);

/// The weighted sum of squares of a hypothesis, with the variances of the fit; infinite if the mechanism cannot be
/// assembled in some row.
double chiSquareOf(const Observations &data, const Fit &fit, const Hypothesis &hypothesis);

} // namespace slidercrank
