// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Linear least squares: the coefficients x of some functions that minimize Σ (values - basis · x)².

#include <Eigen/Core>

namespace slidercrank
{

struct LinearFit {
    Eigen::VectorXd coefficients;
    Eigen::ArrayXd variances; ///< variances of the coefficients if the errors of the values have the variance 1
    Eigen::ArrayXd residuals; ///< values - basis · coefficients
};

/// `basis`: the functions, one in each column; they must be linearly independent.
LinearFit fitLinearly(const Eigen::MatrixXd &basis, const Eigen::ArrayXd &values);

} // namespace slidercrank
