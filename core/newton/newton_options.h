// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings of Newton-Raphson (newton.h).

namespace slidercrank
{

/// The measure of the residual.
enum class ToleranceKind {
    Absolute, ///< ‖C‖, mm and rad mixed, as in the reference report
    Relative  ///< ‖C‖ with the length rows divided by a + b + |c|: the same at every scale
};

/// The starting point of a time step. It also determines when the tolerance is tested.
enum class WarmStart {
    Previous, ///< q of the previous time step; the residual is tested before the last update (reference report)
    Taylor ///< q + q̇ Δt + q̈ Δt²/2 of the previous time step; no update is made once the residual is small enough
};

/// The method for the linear systems. Both give the same iterates except for rounding.
enum class Elimination {
    Dense,     ///< LU of the 12×12 matrix, as in the reference report
    Structured ///< joint by joint, without a matrix: structured_system.h
};

/// The defaults are those of Table 2 of the reference report.
struct NewtonOptions {
    int maxIterations = 10;

    /// The iteration ends when the residual is at most this, and small enough that velocity and acceleration have at
    /// least two correct digits (kResolvedFraction in newton.h). It bounds the residual, not the error. 0: iterate
    /// until the residual no longer decreases.
    double tolerance = 1e-8;

    ToleranceKind toleranceKind = ToleranceKind::Absolute;
    WarmStart warmStart = WarmStart::Previous;
    Elimination elimination = Elimination::Dense;

    friend bool operator==(const NewtonOptions &, const NewtonOptions &) = default;
};

} // namespace slidercrank
