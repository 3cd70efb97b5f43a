// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes all 36 channels of the exact motion from the six that closed_form.h computes.

#include "core/closed_form/closed_form.h"
#include "core/mechanism/state.h"

namespace slidercrank
{

/// Returns all 36 channels of a motion of the mechanism.
///
/// The centres of mass are the midpoints of crank and coupler. That of the coupler is h/2 above A, so that
/// R3y = (a sin θ2 + c) / 2. The function is inline so that the state is written directly to its destination: copying
/// it takes an eighth of the time of computing it.
inline State stateOf(const Mechanism &mechanism, const Motion &motion)
{
    State state;
    const double omega = mechanism.omega2();
    const double aCos = mechanism.a() * motion.crank.cos;
    const double aSin = mechanism.a() * motion.crank.sin;
    setCoordinates(state.q, {.R2x = 0.5 * aCos,
                             .R2y = 0.5 * aSin,
                             .theta2 = motion.theta2,
                             .R3x = aCos + 0.5 * motion.s,
                             .R3y = 0.5 * (aSin + mechanism.c()),
                             .theta3 = motion.theta3,
                             .R4x = motion.R4x,
                             .R4y = mechanism.c()});
    setCoordinates(state.qDot, {.R2x = -0.5 * aSin * omega,
                                .R2y = 0.5 * aCos * omega,
                                .theta2 = omega,
                                .R3x = -aSin * omega + 0.5 * motion.sDot,
                                .R3y = 0.5 * aCos * omega,
                                .theta3 = motion.theta3Dot,
                                .R4x = motion.R4xDot});
    const double omegaSquared = omega * omega;
    setCoordinates(state.qDDot, {.R2x = -0.5 * aCos * omegaSquared,
                                 .R2y = -0.5 * aSin * omegaSquared,
                                 .R3x = -aCos * omegaSquared + 0.5 * motion.sDDot,
                                 .R3y = -0.5 * aSin * omegaSquared,
                                 .theta3 = motion.theta3DDot,
                                 .R4x = motion.R4xDDot});
    state.setStatus(motion.status);
    return state;
}

inline State ClosedForm::stateAt(double t) const
{
    return stateOf(m_mechanism, motionAt(t));
}

} // namespace slidercrank
