// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the report writes down at one instant: C, C_q, C_t and Q_d, at the position that the chosen method finds.
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"
#include "core/sampling/trajectory.h"

namespace slidercrank
{

struct InstantEquations {
    State state; ///< NaN as far as it does not exist

    /// Where C and C_q are evaluated: state.q, or the last iterate where Newton-Raphson did not converge; NaN where
    /// there is no position at all. The others then are NaN too.
    Vector12 q;
    Vector12 C;
    Matrix12 Cq;
    Vector12 Ct;
    Vector12 Qd; ///< NaN where there is no velocity

    bool hasPosition() const { return q.allFinite(); }
};

/// By the method of `settings`; Newton-Raphson starts from the position `step` seconds before, as in a run.
InstantEquations equationsAt(const Mechanism &mechanism, double t, double step, const SolverSettings &settings);

/// The largest singular value over the smallest: by how much relative errors may grow in C_q Δq = -C. It mixes mm and
/// rad, as C_q does, so it depends on the unit of length. Infinite for a singular matrix; precondition: finite entries.
double conditionNumber(const Matrix12 &matrix);

} // namespace slidercrank
