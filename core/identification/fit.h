// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Weighted least squares for one hypothesis by Levenberg-Marquardt (J. Nocedal, S. Wright, "Numerical Optimization",
// 2nd ed., ch. 10.3). The variance of a value is that of its rounding, that of the abscissa's rounding, and the noise
// of its column, which is estimated from the residuals. Free scales and offsets are regressed anew in every trial
// (variable projection): as ordinary unknowns they make a curved valley.

#include "core/identification/hypothesis.h"

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace slidercrank
{

struct Fit {
    Hypothesis hypothesis;                      ///< with the fitted unknowns
    std::vector<double> noiseVariances;         ///< by column
    std::vector<std::vector<double>> residuals; ///< by column and row; NaN where there is no value
    std::vector<std::vector<double>> variances; ///< of the residuals
    double chiSquare = std::numeric_limits<double>::infinity();
    double score = std::numeric_limits<double>::infinity(); ///< lower is better; infinite: no fit
    int iterations = 0;

    bool exists() const { return score < std::numeric_limits<double>::infinity(); }
};

/// At most so many rounds, the noise being estimated anew in each.
Fit fitHypothesis(const Observations &data, Hypothesis hypothesis, int rounds);

/// Residuals, variances and noise of a hypothesis as it stands; no fit if it cannot be assembled in some row.
Fit evaluateHypothesis(const Observations &data, Hypothesis hypothesis);

/// Sets the free scales, and the offsets of the same columns, to those of the best straight lines.
void regressScales(const Observations &data, const Hypothesis &hypothesis, Eigen::VectorXd &unknowns);

/// Jᵀ V⁻¹ J and Jᵀ V⁻¹ r by the unknowns; 1 on the diagonal for what is held.
struct NormalEquations {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd gradient;
};
NormalEquations normalEquations(const Observations &data, const Fit &fit, const Eigen::VectorXd &unknowns);

/// The weighted sum of squares at other unknowns, with the variances of the fit; infinite if it cannot be assembled.
double chiSquareAt(const Observations &data, const Fit &fit, const Eigen::VectorXd &unknowns);

} // namespace slidercrank
