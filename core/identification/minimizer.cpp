// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/minimizer.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

/// The step to the minimum of a quadratic function whose curvature, scaled to a unit diagonal, is increased by
/// `damping`: with more damping, the step becomes shorter and turns downhill.
Eigen::VectorXd dampedStep(const LocalShape &shape, double damping)
{
    const Eigen::VectorXd scale = diagonalScale(shape.curvature);
    Eigen::MatrixXd scaled = scale.asDiagonal() * shape.curvature * scale.asDiagonal();
    scaled.diagonal().array() += damping;
    return -(scale.asDiagonal() * scaled.ldlt().solve(scale.asDiagonal() * shape.gradient));
}

} // namespace

Eigen::VectorXd diagonalScale(const Eigen::MatrixXd &matrix)
{
    constexpr double kSmallestElement = 1e-300; // an unknown without influence has a zero on the diagonal
    return matrix.diagonal().array().max(kSmallestElement).sqrt().inverse();
}

std::optional<Minimum> minimize(const Objective &function, Eigen::VectorXd start, const MinimizerOptions &options)
{
    // A rejected step is repeated with ten times the damping, and a successful one is followed by a tenth of it.
    constexpr double kDampingFactor = 10.0;
    constexpr double kFirstDamping = 1e-3;     // hardly any, because the starts are good
    constexpr double kSmallestDamping = 1e-12; // a smaller one is lost in rounding errors
    constexpr double kLargestDamping = 1e8;    // with more, steps are lost in rounding errors
    constexpr double kSmallDamping = 1e-2;     // with more damping, a small gain may only mean a short step
    std::optional<LocalShape> shape = function(start);
    if (!shape) {
        return std::nullopt;
    }
    Minimum minimum{.point = std::move(start), .shape = *std::move(shape)};
    for (double damping = kFirstDamping; minimum.iterations < options.iterationLimit;) {
        const Eigen::VectorXd point = minimum.point + dampedStep(minimum.shape, damping);
        std::optional<LocalShape> next = function(point);
        ++minimum.iterations;
        const double gain = next ? minimum.shape.value - next->value : -HUGE_VAL;
        if (gain > 0.0) {
            minimum.point = point;
            minimum.shape = *std::move(next);
        }
        if (std::abs(gain) < options.smallestGain && (gain <= 0.0 || damping <= kSmallDamping)) {
            minimum.status = Minimum::Status::Converged;
            break;
        }
        damping = std::max(gain > 0.0 ? damping / kDampingFactor : damping * kDampingFactor, kSmallestDamping);
        if (damping > kLargestDamping) {
            minimum.status = Minimum::Status::NoProgress;
            break;
        }
    }
    return minimum;
}

} // namespace slidercrank
