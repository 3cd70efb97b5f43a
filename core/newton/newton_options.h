// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings of Newton-Raphson (newton.h). The defaults are those of the reference report.

namespace slidercrank
{

/// What the residual is.
enum class ToleranceKind {
    Absolute, ///< ‖C‖, mm and rad mixed, as in the report
    Relative  ///< ‖C‖ with the length rows divided by a + b + |c|: the same at every scale
};

/// Where an instant starts, and with it when the tolerance is tested.
enum class WarmStart {
    Previous, ///< q of the instant before; tested on the residual before an update that is made all the same (report)
    Taylor ///< q + q̇ Δt + q̈ Δt²/2 of the instant before; tested before each update, which may then not be needed
};

/// How the linear systems are solved. Both give the same iterates to rounding.
enum class Elimination {
    Dense,     ///< LU of the 12×12 matrix, as in the report
    Structured ///< joint by joint, without a matrix: structured_system.h
};

/// Table 2 of the report.
struct NewtonOptions {
    int maxIterations = 10;

    /// Iterate until the residual is at most this, and on while it leaves no two digits of the motion (kResolvedPart).
    /// It bounds the residual, not the error. 0: until the residual no longer falls.
    double tolerance = 1e-8;

    ToleranceKind toleranceKind = ToleranceKind::Absolute;
    WarmStart warmStart = WarmStart::Previous;
    Elimination elimination = Elimination::Dense;

    friend bool operator==(const NewtonOptions &, const NewtonOptions &) = default;
};

} // namespace slidercrank
