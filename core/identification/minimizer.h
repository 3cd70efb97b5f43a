// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Minimizes a function of several unknowns by the method of Levenberg and Marquardt (D. Marquardt, J. SIAM 11, 1963).
// The function supplies its gradient and an approximation of its second derivatives, such as 2 JᵀJ for a sum of squared
// residuals with the Jacobian J.

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace slidercrank
{

/// A function near a point: its value, gradient and (approximate, positive semidefinite) second derivatives there.
struct LocalShape {
    double value = 0.0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd curvature;
};

/// Returns nullopt where the function does not exist.
using Objective = std::function<std::optional<LocalShape>(const Eigen::VectorXd &)>;

struct MinimizerOptions {
    int iterationLimit = 200;
    double smallestGain = 1e-4; ///< see Minimum::Status::Converged
};

struct Minimum {
    enum class Status {
        Converged,     ///< the last step changed the value by less than MinimizerOptions::smallestGain. A step that
                       ///< lowered the value counts only if it was hardly damped, because a damped step is short.
        NoProgress,    ///< no step lowers the value, however short
        IterationLimit ///< the limit was reached before one of the above
    };

    /// Why the search ended. fitModel() accepts a minimum with any status; what is missing to the minimum becomes a
    /// part of the standard errors (see stepToMinimum()).
    Status status = Status::IterationLimit;
    Eigen::VectorXd point;
    LocalShape shape; ///< the function near the point
    int iterations = 0;
};

/// Searches a local minimum from `start`. Returns nullopt if the function does not exist there.
std::optional<Minimum> minimize(const Objective &function, Eigen::VectorXd start, const MinimizerOptions &options);

/// The factors by which rows and columns of a positive semidefinite matrix are multiplied to get a unit diagonal.
Eigen::VectorXd diagonalScale(const Eigen::MatrixXd &matrix);

} // namespace slidercrank
