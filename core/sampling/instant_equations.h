// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The constraint equations at one time: C, C_q, C_t and Q_d at the position that the chosen method finds.
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"
#include "core/sampling/trajectory.h"

namespace slidercrank
{

struct InstantEquations {
    State state; ///< NaN as far as it does not exist

    /// Where C and C_q are evaluated: state.q, or the last iterate where Newton-Raphson did not converge; NaN where
    /// there is no position at all, as are the others then.
    Vector12 q;
    Vector12 C = Vector12::Constant(kNone);
    Matrix12 Cq = Matrix12::Constant(kNone);
    Vector12 Ct = Vector12::Constant(kNone);
    Vector12 Qd = Vector12::Constant(kNone); ///< NaN also where there is no velocity

    bool hasPosition() const { return q.allFinite(); }
};

/// By the method of `settings`; Newton-Raphson has a warm start from the position `step` seconds before, as when
/// sampling.
InstantEquations equationsAt(const Mechanism &mechanism, double t, double step, const SolverSettings &settings);

/// The largest singular value divided by the smallest: the factor by which relative errors may grow in C_q Δq = -C. It
/// depends on the unit of length, because C_q mixes mm and rad. Infinite for a singular matrix; precondition: finite
/// entries.
double conditionNumber(const Matrix12 &matrix);

} // namespace slidercrank
