// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Newton-Raphson: C_q Δq = -C until C is small, then velocity and acceleration from C_q at the final q. The defaults
// are the report's: each instant starts from the coordinates of the one before, and a dense 12×12 LU solves the
// systems.
//
// It never leaves the wanted assembly: a warm start whose coupler angle leaves the branch's half turn is started again
// from afar (assemble), from where Newton's way to the wanted root is monotone. Whether a position exists at all is
// decided before the first iteration, never by it.
//
// Source: the report, section "Newton-Raphson" and Table 2; Shabana, "Computational Dynamics", section 3.5.
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"
#include "core/newton/newton_options.h"

#include <array>

namespace slidercrank
{

/// q holds θ2 in one double, which knows the angle to 0.001 rad up to this |ω2 t| + |θ20| (rad), and beyond it no motion:
/// NotFinite.
inline constexpr double kLargestDrive = 8e12;

/// A start from afar needs up to 13 iterations, 29 at an exact toggle, so assemble() has a cap of its own.
inline constexpr int kAssemblyIterations = 60;

struct NewtonResult {
    Vector12 q;                        ///< θ3 within the branch's half turn; the last iterate where not converged
    int iterations = 0;                ///< linear systems solved, the abandoned warm start's included
    /// Solved: residual ≤ tolerance (or, for 0, no longer falling). IterationLimit at once where rounding alone leaves
    /// θ3 unknown: lengths of a few bits, a coupler of 1e-11 a.
    Status status = Status::NotFinite;
    bool startedAfar = false;          ///< the start was not (or not any more) the warm one

    /// The residual before each iteration, then that of the answer; the first kHistory of the last start.
    static constexpr int kHistory = 64;
    std::array<double, kHistory> residuals; ///< the first residualCount; setting them all would cost as much as a step
    int residualCount = 0;
    double residual() const { return residualCount > 0 ? residuals[static_cast<std::size_t>(residualCount - 1)] : 0.0; }
};

/// Afar: θ2 exact, the coupler along x (open: 0, crossed: π). From there Newton's way to the wanted root is monotone.
Vector12 farStart(const Mechanism &mechanism, double t);

/// From afar.
NewtonResult assemble(const Mechanism &mechanism, double t, const NewtonOptions &options = {});

/// From coordinates near the answer: those of a neighbouring instant, or what is expected of this one.
NewtonResult track(const Mechanism &mechanism, double t, const Vector12 &start, const NewtonOptions &options = {});

/// Velocity and acceleration with C_q at a solved position, whose residual ‖C‖ (mm and rad mixed) is given. Status
/// Singular (and NaN) where they do not exist, or are lost in what is left of the residual: see kResolvedPart.
State differentiate(const Mechanism &mechanism, const Vector12 &q, double residual = 0.0);

/// One instant of a run.
struct NewtonInstant {
    double t = 0.0;
    State state; ///< NaN as far as it does not exist

    // As in NewtonResult.
    Vector12 q;
    int iterations = 0;
    double residual = 0.0;
    Status positionStatus = Status::NotFinite;
    bool startedAfar = false;
};

/// The state at t, started from `before` as options.warmStart says, or from afar where `before` has no position.
NewtonInstant solveInstant(const Mechanism &mechanism, double t, const NewtonInstant &before,
                           const NewtonOptions &options = {});

/// The same in place, from the instant that `instant` holds to the one at t: a run then copies nothing.
void advance(const Mechanism &mechanism, double t, NewtonInstant &instant, const NewtonOptions &options = {});

/// Velocity and acceleration are given where r/b, r (mm) being the residual, is at most this part of cos² θ3, or of as
/// much less as their terms cancel. For a residual of r
///
///     leaves sin θ3 uncertain by 2r/b, where all four rows that make it up pull one way,
///     so θ3 by δ, with cos θ3 δ + δ²/2 = 2r/b,
///     velocity and acceleration, which go with 1/cos θ3 to 1/cos³ θ3, by δ/cos θ3 to three times that: 0.2 % to 0.6 %.
///
/// Where r is 0, rounding leaves θ3 uncertain all the same, by up to what r/b = 5e-16 would (as measured beside random
/// toggles), and 2.2e-16 stands for it; θ2 is uncertain by what was rounded of ω2 t and θ20. Iteration goes on past the
/// tolerance until r is small enough for that, and at most this part of a, or is no more than rounding.
///
/// Where a ≈ b and c ≈ 0, the terms of θ̈3 cancel everywhere but at the toggle; then it is given where it has digits
/// beside what a run of a hundred steps a turn sees of it.
inline constexpr double kResolvedPart = 1.0 / 1024.0;

} // namespace slidercrank
