// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/least_squares.h"

#include <Eigen/Cholesky>

namespace slidercrank
{

LinearFit fitLinearly(const Eigen::MatrixXd &basis, const Eigen::ArrayXd &values)
{
    const Eigen::LDLT<Eigen::MatrixXd> normal(basis.transpose() * basis);
    const Eigen::MatrixXd inverse = normal.solve(Eigen::MatrixXd::Identity(basis.cols(), basis.cols()));
    const Eigen::VectorXd coefficients = normal.solve(basis.transpose() * values.matrix());
    return {.coefficients = coefficients,
            .variances = inverse.diagonal(),
            .residuals = values - (basis * coefficients).array()};
}

} // namespace slidercrank
