// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Evaluates the constraint equations at one time step: C, C_q, C_t and Q_d at the position that the chosen method
// finds. Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"
#include "core/sampling/trajectory.h"

namespace slidercrank
{

struct TimeStepEquations {
    State state; ///< values that do not exist are NaN

    /// The coordinates at which C and C_q are evaluated: state.q, or the last iterate if Newton-Raphson did not
    /// converge. If the status is NotAssemblable or NotFinite, there are none, and all numbers are NaN.
    Vector12 q;
    Vector12 C = Vector12::Constant(kNone);
    Matrix12 Cq = Matrix12::Constant(kNone);
    double determinant = kNone; ///< of C_q: -b cos θ3, mm
    Vector12 Ct = Vector12::Constant(kNone);
    Vector12 Qd = Vector12::Constant(kNone); ///< also NaN if there is no velocity

    bool hasPosition() const { return q.allFinite(); }
};

/// Solves the time step at time t (s) by the method of `settings`. As in sampling, Newton-Raphson has a warm start from
/// the position at t - step.
TimeStepEquations equationsAt(const Mechanism &mechanism, double t, double step, const SolverSettings &settings);

/// Returns the largest singular value divided by the smallest: the factor by which relative errors can grow in
/// C_q Δq = -C. It depends on the unit of length, because C_q mixes mm and rad. Infinite for a singular matrix.
/// Requires finite entries.
double conditionNumber(const Matrix12 &matrix);

} // namespace slidercrank
