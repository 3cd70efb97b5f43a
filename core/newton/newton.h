// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Newton-Raphson: C_q Δq = -C until C is small, then velocity and acceleration from C_q at the final q. The defaults
// are those of the reference report: each time step starts from the coordinates of the one before (a warm start), and a
// dense 12×12 LU solves the linear systems.
//
// The solver never changes the assembly silently: a warm start whose coupler angle leaves the branch's half turn is
// replaced by a cold start, from which Newton-Raphson converges monotonically to the wanted root. Whether a position
// exists at all is decided before the first iteration, never by the iteration.
//
// Source: the reference report, section "Newton-Raphson" and Table 2; Shabana, "Computational Dynamics", section 3.5.
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"
#include "core/newton/newton_options.h"

#include <vector>

namespace slidercrank
{

/// q holds θ2 in one double, which resolves 0.001 rad up to this |ω2 t| + |θ20| (rad). Beyond it: NotFinite.
inline constexpr double kLargestDrive = 8e12;

/// A cold start needs up to 13 iterations, 29 at an exact toggle, so it has its own iteration limit (or that of the
/// options, if larger).
inline constexpr int kColdStartIterations = 60;

/// One time step solved by Newton-Raphson.
struct NewtonInstant {
    double t = 0.0;
    State state; ///< NaN as far as it does not exist

    Vector12 q;            ///< the last iterate, also where it did not converge; NaN where there is no position
    int iterations = 0;    ///< linear systems solved for the position, those of an abandoned warm start included
    double residual = 0.0; ///< of q, as the tolerance kind of the options measures it

    /// Solved: residual <= tolerance or, for a tolerance of 0, no longer decreasing. IterationLimit without any
    /// iteration where rounding alone leaves θ3 unknown: a coupler of 1e-11 a.
    Status positionStatus = Status::NotFinite;
    bool isColdStart = false; ///< the iterates began at the cold start
};

struct Iteration {
    Vector12 q;
    double residual = 0.0;
};

/// The start, then each iterate, of the last start only. Beyond kLongestHistory the last entry is overwritten. Empty
/// where there is no position to look for.
using IterationHistory = std::vector<Iteration>;
inline constexpr std::size_t kLongestHistory = 64;

/// The coordinates from which a cold start begins: θ2 exact, the coupler along x (open: θ3 = 0, crossed: π).
Vector12 coldStart(const Mechanism &mechanism, double t);

/// Moves `instant` to the time t. The iteration starts from its position as options.warmStart says, or cold where it
/// has none, as a new NewtonInstant. Nothing is allocated unless a history is asked for.
void advance(const Mechanism &mechanism, double t, NewtonInstant &instant, const NewtonOptions &options = {},
             IterationHistory *history = nullptr);

/// The same by value.
NewtonInstant solve(const Mechanism &mechanism, double t, const NewtonOptions &options = {}, NewtonInstant start = {},
                    IterationHistory *history = nullptr);

/// Velocity and acceleration are given where r/b, r (mm) being the residual, is at most this part of cos² θ3, or of a
/// correspondingly smaller value where their terms cancel. A residual of r
///
///     leaves sin θ3 uncertain by 2r/b, where the four rows that make it up all deviate in the same direction,
///     so θ3 by δ, with cos θ3 δ + δ²/2 = 2r/b,
///     velocity and acceleration, which vary as 1/cos θ3 to 1/cos³ θ3, by δ/cos θ3 to three times that: 0.2 % to 0.6 %.
///
/// Where r is 0, rounding still leaves θ3 uncertain, by up to what r/b = 5e-16 would (measured at random time stamps
/// near toggles); r/b = 2.2e-16 represents it. θ2 is uncertain by the rounding of ω2 t and θ20. The iteration continues
/// below the tolerance until r is small enough for that, and at most this part of a, or no larger than its rounding.
inline constexpr double kResolvedPart = 1.0 / 1024.0;

} // namespace slidercrank
