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

/// A start from afar needs up to 13 iterations, 29 at an exact toggle, so assemble() has a cap of its own.
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

/// Velocity and acceleration with C_q at a solved position, whose residual ‖C‖ (mm and rad mixed) is given. Status
/// Singular (and NaN) where they do not exist, or are lost in what is left of the residual: see kResolvedCosine.
State differentiate(const Mechanism &mechanism, const Vector12 &q, double residual = 0.0);

/// A residual r leaves θ3 uncertain by δ with cos θ3 δ + δ²/2 = r/b, and the derivatives, which go with 1/cos θ3 to
/// 1/cos³ θ3, by δ/cos θ3 to three times that. They are given where cos² θ3 is at least this many times r/b: δ/cos θ3
/// is 1.6 % there at most. Where r is 0, rounding leaves θ3 uncertain all the same, as if r/b were about 2.2e-16.
inline constexpr double kResolvedCosine = 64.0;

} // namespace slidercrank
