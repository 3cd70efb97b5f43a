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
    state.status = motion.status;
    const auto set = [](Vector12 &values, double pinX, double pinY, double theta2, double s, double R4y, double theta3,
                        double R4x) {
        values << 0.0, 0.0, 0.0, 0.5 * pinX, 0.5 * pinY, theta2, pinX + 0.5 * s, 0.5 * (pinY + R4y), theta3, R4x, R4y,
            0.0;
    };
    const double omega = m_mechanism.omega2();
    const double omegaSquared = omega * omega;
    const double pinX = m_mechanism.a() * motion.crank.cos;
    const double pinY = m_mechanism.a() * motion.crank.sin;
    set(state.q, pinX, pinY, motion.theta2, motion.s, m_mechanism.c(), motion.theta3, motion.R4x);
    set(state.qDot, -pinY * omega, pinX * omega, omega, motion.sDot, 0.0, motion.theta3Dot, motion.R4xDot);
    set(state.qDDot, -pinX * omegaSquared, -pinY * omegaSquared, 0.0, motion.sDDot, 0.0, motion.theta3DDot,
        motion.R4xDDot);
    if (motion.status != Status::Solved) {
        state.qDot.setConstant(kNone);
        state.qDDot.setConstant(kNone);
        if (motion.status != Status::Singular) {
            state.q.setConstant(kNone);
        }
    }
    return state;
}

} // namespace slidercrank
