// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The report's Newton-Raphson: C_q Δq = -C with a dense 12×12 LU, then velocity and acceleration from C_q at the final
// q.
//
// It never leaves the wanted assembly: a warm start whose coupler angle leaves the branch's half turn is started again
// from afar (assemble), from where Newton's way to the wanted root is monotone. Whether a position exists at all is
// decided before the first iteration, never by it.
//
// Source: the report, section "Newton-Raphson" and Table 2; Shabana, "Computational Dynamics", section 3.5.
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism.h"

#include <array>

namespace slidercrank
{

/// Table 2 of the report.
struct NewtonOptions {
    int maxIterations = 10;

    /// Iterate until ‖C‖ (mm and rad mixed, before the update, as in the report) is at most this. It bounds the
    /// residual, not the error. 0: until the residual no longer falls.
    double tolerance = 1e-8;

    friend bool operator==(const NewtonOptions &, const NewtonOptions &) = default;
};

/// A start from afar needs up to 13 iterations, 23 at an exact toggle, so assemble() has a cap of its own.
inline constexpr int kAssemblyIterations = 60;

struct NewtonResult {
    Vector12 q = Vector12::Zero();     ///< θ3 within the branch's half turn; the last iterate where not converged
    int iterations = 0;                ///< linear systems solved, the abandoned warm start's included
    Status status = Status::NotFinite; ///< Solved: ‖C‖ ≤ tolerance (or, for 0, no longer falling)
    bool startedAfar = false;          ///< the start was not (or not any more) the warm one

    /// ‖C‖ before each iteration, then that of the answer; the first kHistory of the last start.
    static constexpr int kHistory = 64;
    std::array<double, kHistory> residuals{};
    int residualCount = 0;
    double residual() const { return residualCount > 0 ? residuals[static_cast<std::size_t>(residualCount - 1)] : 0.0; }
};

/// From afar: θ2 exact, the coupler along x (open: 0, crossed: π).
NewtonResult assemble(const Mechanism &mechanism, double t, const NewtonOptions &options = {});

/// From the coordinates of a neighbouring instant.
NewtonResult track(const Mechanism &mechanism, double t, const Vector12 &start, const NewtonOptions &options = {});

/// Velocity and acceleration at a solved position. Status Singular (and NaN) where |cos θ3| < kSingularCosine.
State differentiate(const Mechanism &mechanism, const Vector12 &q);

/// Below this |cos θ3| (of 1) a double-precision θ3 found by iteration has no correct digit left in its cosine: θ3 is
/// known to about u/|cos θ3|, and that reaches |cos θ3| at √u = 1.05e-8. Four times that, so that one digit is left.
inline constexpr double kSingularCosine = 4.2e-8;

} // namespace slidercrank
