// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Solves a time step by Newton-Raphson: iterates C_q Δq = -C until ‖C‖ is small, then computes velocity and
// acceleration with C_q at the final q. The defaults are those of the reference report: each time step starts from the
// coordinates of the previous one (a warm start), and a dense 12×12 LU factorization solves the linear systems.
//
// The solver never changes the branch silently: if the iterates of a warm start leave the range of θ3 of
// the branch, the time step is solved again from a cold start, from which Newton-Raphson converges monotonically to the
// root of the branch. Whether the mechanism can be assembled is decided before the first iteration, not by the
// iteration.
//
// Source: the reference report, section "Newton-Raphson" and Table 2; Shabana, "Computational Dynamics", section 3.5.
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"
#include "core/newton/newton_options.h"

#include <vector>

namespace slidercrank
{

/// The largest |ω2 t| + |θ20| (rad). q holds θ2 in one double, and neighbouring doubles of this size differ by 0.001
/// rad. The status of a time step with a larger value is NotFinite.
inline constexpr double kLargestDrive = 8e12;

/// The iteration limit of a cold start, which needs up to 13 iterations, 29 at an exact toggle. The limit of the
/// options applies if it is larger.
inline constexpr int kColdStartIterations = 60;

/// The result of one time step.
struct NewtonTimeStep {
    double t = 0.0;
    State state; ///< values that do not exist are NaN

    Vector12 q;         ///< the last iterate, converged or not; NaN if no iteration began (NotAssemblable, NotFinite)
    int iterations = 0; ///< linear systems solved for the position, including those of an abandoned warm start
    double residual = 0.0; ///< of q, as the tolerance kind of the options measures it

    /// Solved: residual <= tolerance or, for a tolerance of 0, no longer decreasing. IterationLimit without any
    /// iteration if rounding alone leaves θ3 undetermined (a coupler of 1e-11 a).
    Status positionStatus = Status::NotFinite;
    bool isColdStart = false; ///< the iterates that led to `q` began at coldStart()
};

/// One iterate and its residual.
struct Iteration {
    Vector12 q;
    double residual = 0.0;
};

/// The starting point and the iterates that followed it, without those of an abandoned warm start. If there are more
/// than kLongestHistory, the last entry is overwritten. Empty if no iteration took place.
using IterationHistory = std::vector<Iteration>;
inline constexpr std::size_t kLongestHistory = 64;

/// Returns the coordinates of a cold start at time t (s): θ2 as driven, and the coupler parallel to the slider's line,
/// with θ3 = 0 on the open branch and θ3 = π on the crossed one.
Vector12 coldStart(const Mechanism &mechanism, double t);

/// Replaces `timeStep`, the result of the previous time step, by the result at time t (s). The iteration starts from
/// the previous position as options.warmStart specifies, or from coldStart() if there is none, as in a new
/// NewtonTimeStep. Allocates no memory unless a history is requested.
void advance(const Mechanism &mechanism, double t, NewtonTimeStep &timeStep, const NewtonOptions &options = {},
             IterationHistory *history = nullptr);

/// Returns the result at time t (s), starting from `start`, as advance() does.
NewtonTimeStep solve(const Mechanism &mechanism, double t, const NewtonOptions &options = {}, NewtonTimeStep start = {},
                     IterationHistory *history = nullptr);

/// Velocity and acceleration are returned if r/b is at most this fraction of cos² θ3, where r (mm) is the residual. The
/// limit is correspondingly smaller if their terms cancel. The effects of a residual r are:
///
///     sin θ3 is uncertain by 2r/b, if the four rows that determine it all deviate in the same direction;
///     θ3 is then uncertain by δ, where cos θ3 δ + δ²/2 = 2r/b;
///     velocity and acceleration vary as 1/cos θ3 to 1/cos³ θ3, and are uncertain by δ/cos θ3 to three times that:
///     0.2 % to 0.6 %.
///
/// Even if r is 0, rounding makes θ3 uncertain: at worst as r/b = 5e-16 would (measured at random time stamps near
/// toggles). The code assumes r/b = 2.2e-16. Moreover, θ2 is uncertain by the rounding of ω2 t and θ20.
///
/// The iteration continues below the tolerance until r satisfies this limit and is at most this fraction of a, or until
/// r is no larger than its own rounding.
inline constexpr double kResolvedFraction = 1.0 / 1024.0;

} // namespace slidercrank
