// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes all 36 channels of the exact motion from the six of closed_form.h.

#include "core/closed_form/closed_form.h"
#include "core/mechanism/state.h"

namespace slidercrank
{

// The centres of mass are the midpoints of crank and coupler. That of the coupler is h/2 above A, so that
// R3y = (a sin θ2 + c) / 2. The function is inline so that the state is written directly to its destination: copying it
// takes an eighth of the time of computing it.
inline State ClosedForm::stateAt(double t) const
{
    const Motion motion = motionAt(t);
    State state;
    const double omega = m_mechanism.omega2();
    const double aCos = m_mechanism.a() * motion.crank.cos;
    const double aSin = m_mechanism.a() * motion.crank.sin;
    state.q << 0.0, 0.0, 0.0, 0.5 * aCos, 0.5 * aSin, motion.theta2, aCos + 0.5 * motion.s,
        0.5 * (aSin + m_mechanism.c()), motion.theta3, motion.R4x, m_mechanism.c(), 0.0;
    const double omegaSquared = omega * omega;
    state.qDot << 0.0, 0.0, 0.0, -0.5 * aSin * omega, 0.5 * aCos * omega, omega, -aSin * omega + 0.5 * motion.sDot,
        0.5 * aCos * omega, motion.theta3Dot, motion.R4xDot, 0.0, 0.0;
    state.qDDot << 0.0, 0.0, 0.0, -0.5 * aCos * omegaSquared, -0.5 * aSin * omegaSquared, 0.0,
        -aCos * omegaSquared + 0.5 * motion.sDDot, -0.5 * aSin * omegaSquared, motion.theta3DDot, motion.R4xDDot, 0.0,
        0.0;
    state.setStatus(motion.status);
    return state;
}

} // namespace slidercrank
