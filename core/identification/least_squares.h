// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Linear least squares with a few unknowns. Written out, because the decompositions of Eigen take longer to compile
// than all other code of this module.

#include <Eigen/Core>

#include <span>

namespace slidercrank
{

/// Solves A X = B for a symmetric positive definite A by Cholesky's method (G. Golub, C. Van Loan, "Matrix
/// Computations", 4th ed., ch. 4.2). A is first scaled to a unit diagonal, to which `damping` is then added. Pivots of
/// a singular matrix are replaced by 1e-17.
Eigen::MatrixXd solveSymmetric(Eigen::MatrixXd matrix, Eigen::MatrixXd right, double damping = 0.0);

/// The square root of the ratio of the largest to the smallest eigenvalue of a symmetric positive definite matrix, and
/// of its inverse, both scaled to a unit diagonal of the matrix.
double conditionNumber(const Eigen::MatrixXd &matrix, const Eigen::MatrixXd &inverse);

/// One column for each angle (rad): 1, then cosine and sine of each harmonic.
Eigen::MatrixXd harmonicBasis(std::span<const double> angles, Eigen::Index harmonics);

/// The part of the sum of squares of (values - center) that a linear combination of the rows of `basis` explains, from
/// 0 to 1. `basis` has one column for each value; NaN values are skipped.
double explainedPart(const Eigen::MatrixXd &basis, std::span<const double> values, double center);

/// A polynomial fitted to points, in powers of (t - origin).
struct Polynomial {
    Eigen::VectorXd coefficients;
    Eigen::VectorXd standardErrors; ///< for points with a standard error of 1
};

struct Point {
    double t = 0.0;
    double y = 0.0;
};

Polynomial fitPolynomial(std::span<const Point> points, double origin, Eigen::Index terms);

} // namespace slidercrank
