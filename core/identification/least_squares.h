// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Linear least squares with a few unknowns.

#include <Eigen/Core>

#include <span>

namespace slidercrank
{

/// Solves A X = B for a symmetric positive definite A by Cholesky's method (G. Golub, C. Van Loan, "Matrix
/// Computations", 4th ed., ch. 4.2). A is first scaled to a unit diagonal, to which `damping` is then added. Pivots of
/// a singular matrix are replaced by 1e-17.
Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd &matrix, const Eigen::MatrixXd &right, double damping = 0.0);

/// The square root of the ratio of the largest to the smallest eigenvalue of a symmetric positive definite matrix,
/// scaled to a unit diagonal.
double conditionNumber(const Eigen::MatrixXd &matrix);

/// One column for each angle (rad): 1, then cosine and sine of each harmonic.
Eigen::MatrixXd harmonicBasis(std::span<const double> angles, Eigen::Index harmonics);

/// One column for each time: its powers 0, 1, …
Eigen::MatrixXd powerBasis(std::span<const double> times, Eigen::Index terms);

/// A linear combination of the rows of a basis.
struct LinearFit {
    Eigen::VectorXd coefficients;
    double explained = 0.0; ///< part of the sum of squares of the values, from 0 to 1
};

/// Fits (values - center) by a basis with one column for each value. NaN values are skipped.
LinearFit fitLinear(Eigen::MatrixXd basis, std::span<const double> values, double center = 0.0);

/// The autocorrelation at `lag`, in standard deviations of that of independent values.
double autocorrelation(std::span<const double> values, std::size_t lag);

} // namespace slidercrank
