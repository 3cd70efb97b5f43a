// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/least_squares.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// By power iteration.
double largestEigenvalue(const Eigen::MatrixXd &matrix)
{
    constexpr int kIterations = 60;
    Eigen::VectorXd vector = Eigen::VectorXd::LinSpaced(matrix.rows(), 1.0, 2.0).normalized();
    double eigenvalue = 0.0;
    for (int i = 0; i < kIterations; ++i) {
        const Eigen::VectorXd product = matrix.lazyProduct(vector);
        eigenvalue = product.norm();
        vector = product / eigenvalue;
    }
    return eigenvalue;
}

/// The lower half of Σ basis basisᵀ, and Σ value · basis: the normal equations of a linear fit.
struct LinearSystem {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right;

    explicit LinearSystem(Eigen::Index terms)
        : matrix(Eigen::MatrixXd::Zero(terms, terms))
        , right(Eigen::VectorXd::Zero(terms))
    {
    }

    void add(const double *basis, double value)
    {
        const Eigen::Index terms = right.size();
        for (Eigen::Index k = 0; k < terms; ++k) {
            for (Eigen::Index l = k; l < terms; ++l) {
                matrix(l, k) += basis[l] * basis[k];
            }
            right[k] += value * basis[k];
        }
    }
};

} // namespace

Eigen::MatrixXd solveSymmetric(Eigen::MatrixXd matrix, Eigen::MatrixXd right, double damping)
{
    constexpr double kSmallestPivot = 1e-17;
    const Eigen::Index n = matrix.rows();
    const Eigen::VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
    Eigen::VectorXd pivots(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        right.row(k) *= scale[k];
        for (Eigen::Index i = k; i < n; ++i) {
            matrix(i, k) *= scale[i] * scale[k];
        }
        matrix(k, k) += damping;
    }
    for (Eigen::Index k = 0; k < n; ++k) { // matrix = L D Lᵀ, right = L⁻¹ right
        pivots[k] = std::max(matrix(k, k), kSmallestPivot);
        for (Eigen::Index i = k + 1; i < n; ++i) {
            const double factor = matrix(i, k) / pivots[k];
            for (Eigen::Index j = i; j < n; ++j) {
                matrix(j, i) -= factor * matrix(j, k);
            }
            right.row(i) -= factor * right.row(k);
        }
    }
    for (Eigen::Index k = n - 1; k >= 0; --k) {
        for (Eigen::Index i = k + 1; i < n; ++i) {
            right.row(k) -= matrix(i, k) * right.row(i);
        }
        right.row(k) /= pivots[k];
    }
    for (Eigen::Index k = 0; k < n; ++k) {
        right.row(k) *= scale[k];
    }
    return right;
}

double conditionNumber(const Eigen::MatrixXd &matrix, const Eigen::MatrixXd &inverse)
{
    const Eigen::VectorXd scale = matrix.diagonal().cwiseSqrt();
    const Eigen::MatrixXd scales = scale.lazyProduct(scale.transpose());
    return std::sqrt(largestEigenvalue(matrix.cwiseQuotient(scales)) * largestEigenvalue(inverse.cwiseProduct(scales)));
}

Eigen::MatrixXd harmonicBasis(std::span<const double> angles, Eigen::Index harmonics)
{
    Eigen::MatrixXd basis(2 * harmonics + 1, static_cast<Eigen::Index>(angles.size()));
    for (Eigen::Index i = 0; i < basis.cols(); ++i) {
        const double c = std::cos(angles[static_cast<std::size_t>(i)]);
        const double s = std::sin(angles[static_cast<std::size_t>(i)]);
        basis(0, i) = 1.0;
        basis(1, i) = c;
        basis(2, i) = s;
        for (Eigen::Index k = 3; k < basis.rows(); k += 2) {
            basis(k, i) = basis(k - 2, i) * c - basis(k - 1, i) * s;
            basis(k + 1, i) = basis(k - 1, i) * c + basis(k - 2, i) * s;
        }
    }
    return basis;
}

double explainedPart(const Eigen::MatrixXd &basis, std::span<const double> values, double center)
{
    constexpr double kRegularization = 1e-9;
    LinearSystem equations(basis.rows());
    double squares = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isnan(values[i])) {
            const double value = values[i] - center;
            equations.add(basis.data() + basis.rows() * static_cast<Eigen::Index>(i), value);
            squares += value * value;
        }
    }
    if (!(squares > 0.0)) {
        return 0.0;
    }
    const Eigen::MatrixXd solution = solveSymmetric(equations.matrix, equations.right, kRegularization);
    return std::clamp(solution.col(0).dot(equations.right) / squares, 0.0, 1.0);
}

Polynomial fitPolynomial(std::span<const Point> points, double origin, Eigen::Index terms)
{
    LinearSystem equations(terms);
    Eigen::VectorXd powers(terms);
    for (const Point &point : points) {
        for (Eigen::Index k = 0; k < terms; ++k) {
            powers[k] = k == 0 ? 1.0 : powers[k - 1] * (point.t - origin);
        }
        equations.add(powers.data(), point.y);
    }
    const Eigen::MatrixXd inverse = solveSymmetric(equations.matrix, Eigen::MatrixXd::Identity(terms, terms));
    return {solveSymmetric(equations.matrix, equations.right).col(0), inverse.diagonal().cwiseMax(0.0).cwiseSqrt()};
}

} // namespace slidercrank
