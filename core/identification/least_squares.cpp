// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/least_squares.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kSmallestPivot = 1e-17;

/// The factors that scale a matrix to a unit diagonal.
Eigen::VectorXd scalesOf(const Eigen::MatrixXd &matrix)
{
    return matrix.diagonal().cwiseSqrt().cwiseInverse();
}

} // namespace

Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd &matrix, const Eigen::MatrixXd &right, double damping)
{
    const Eigen::VectorXd scales = scalesOf(matrix);
    Eigen::MatrixXd scaled = scales.asDiagonal() * matrix * scales.asDiagonal();
    scaled.diagonal().array() += damping;
    const Eigen::LDLT<Eigen::MatrixXd> factors(scaled);
    Eigen::MatrixXd solution = factors.transpositionsP() * (scales.asDiagonal() * right);
    factors.matrixL().solveInPlace(solution);
    solution = factors.vectorD().cwiseMax(kSmallestPivot).cwiseInverse().asDiagonal() * solution;
    factors.matrixU().solveInPlace(solution);
    return scales.asDiagonal() * (factors.transpositionsP().transpose() * solution);
}

double conditionNumber(const Eigen::MatrixXd &matrix)
{
    const Eigen::VectorXd scales = scalesOf(matrix);
    const Eigen::MatrixXd scaled = scales.asDiagonal() * matrix * scales.asDiagonal();
    // Without a QR decomposition, which a square matrix does not need, this compiles in a third of the time.
    const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> solver(scaled);
    return std::sqrt(solver.singularValues().maxCoeff() / std::max(solver.singularValues().minCoeff(), kSmallestPivot));
}

Eigen::MatrixXd harmonicBasis(std::span<const double> angles, Eigen::Index harmonics)
{
    const Eigen::Map<const Eigen::Array<double, 1, Eigen::Dynamic>> angle(angles.data(), std::ssize(angles));
    Eigen::ArrayXXd basis(2 * harmonics + 1, angle.size());
    basis.row(0) = 1.0;
    basis.row(1) = angle.cos();
    basis.row(2) = angle.sin();
    for (Eigen::Index k = 3; k < basis.rows(); k += 2) {
        basis.row(k) = basis.row(k - 2) * basis.row(1) - basis.row(k - 1) * basis.row(2);
        basis.row(k + 1) = basis.row(k - 1) * basis.row(1) + basis.row(k - 2) * basis.row(2);
    }
    return basis.matrix();
}

Eigen::MatrixXd powerBasis(std::span<const double> times, Eigen::Index terms)
{
    const Eigen::Map<const Eigen::RowVectorXd> t(times.data(), std::ssize(times));
    Eigen::MatrixXd basis(terms, t.cols());
    for (Eigen::Index k = 0; k < terms; ++k) {
        basis.row(k) = t.array().pow(static_cast<double>(k));
    }
    return basis;
}

LinearFit fitLinear(Eigen::MatrixXd basis, std::span<const double> values, double center)
{
    constexpr double kRegularization = 1e-12; // more than the rounding errors of the products
    Eigen::VectorXd known(basis.cols());
    for (Eigen::Index i = 0; i < known.size(); ++i) {
        const double value = values[static_cast<std::size_t>(i)];
        known[i] = std::isnan(value) ? 0.0 : value - center;
        if (std::isnan(value)) {
            basis.col(i).setZero();
        }
    }
    const Eigen::VectorXd right = basis * known;
    const Eigen::VectorXd coefficients = solveSymmetric(basis * basis.transpose(), right, kRegularization);
    const double squares = known.squaredNorm();
    return {coefficients, squares > 0.0 ? std::clamp(coefficients.dot(right) / squares, 0.0, 1.0) : 0.0};
}

double autocorrelation(std::span<const double> values, std::size_t lag)
{
    const Eigen::Map<const Eigen::VectorXd> all(values.data(), std::ssize(values));
    const Eigen::Index rest = all.size() - static_cast<Eigen::Index>(lag);
    const double squares = all.squaredNorm();
    return squares > 0.0
               ? all.head(rest).dot(all.tail(rest)) / squares * static_cast<double>(all.size()) / std::sqrt(rest)
               : 0.0;
}

} // namespace slidercrank
