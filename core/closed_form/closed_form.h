// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The exact motion, in closed form, to the last digit that a double holds: also at and beside a toggle, where the
// coupler stands square to the slider's line, and at any time. It knows nothing of the constraints, so that its
// agreement with Newton-Raphson is evidence.
//
// With ω = ω2 and the names of clearance.h:
//
//     s   = b cos θ3 = ±√(p m)          + open, - crossed
//     θ3  = atan2(g h, s)               crossed: π - atan2(g h, |s|), so that it is continuous; within [-π/2, 3π/2]
//     θ̇3  = -a ω cos θ2 / s             θ̈3  = g a ω² (a C σ² + x ε L) / s³
//     ṡ   = -(g h) θ̇3                   s̈   = -a ω² G / s³
//     R4x = a cos θ2 + s
//
// For a rocker (ε < 0) p or m is a difference near a limit, and is then taken from a sine to some 30 digits.
//
// They are the textbook's (Norton, "Design of Machinery", eq. 4.16, 6.22, 7.15) freed of every difference of nearly
// equal numbers. Lengths in mm, angles in rad, time in s.

#include "core/closed_form/clearance.h"
#include "core/closed_form/motion_constants.h"
#include "core/mechanism/mechanism.h"
#include "core/mechanism/two_part_angle.h"

#include <limits>

namespace slidercrank
{

/// The six plotted channels at one instant, with what the other thirty follow from.
struct Motion {
    double theta2;                        ///< rad, not wrapped
    SinCos crank;                         ///< sin θ2, cos θ2
    double s;                             ///< b cos θ3, mm
    double theta3, theta3Dot, theta3DDot; ///< rad
    double sDot, sDDot;
    double R4x, R4xDot, R4xDDot; ///< mm
    Status status;               ///< Solved, Singular (derivatives NaN), NotAssemblable or NotFinite (all NaN)
};

class ClosedForm
{
public:
    explicit ClosedForm(const Mechanism &mechanism);

    /// The six plotted channels at time t (s).
    Motion motionAt(double t) const;

    /// All 36 channels at time t (s).
    State stateAt(double t) const;

private:
    /// By the standard library's functions, for what the kernel leaves: an instant that is not Solved, one near a
    /// limit of a rocker, or one whose angle is too large for its reduction.
    Motion motionStepByStep(double t) const;

    Mechanism m_mechanism;
    Clearance m_clearance;
    MotionConstants m_constants;
};

// Crank and coupler turn about their ends, the slider translates; the centres of mass lie half way. The coupler's rises
// by h/2 above A, so R3y = (a sin θ2 + c) / 2. Defined here, so that the state is written where it is wanted: copying
// it takes an eighth of the time that working it out does.
inline State ClosedForm::stateAt(double t) const
{
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const Motion motion = motionAt(t);
    State state;
    state.status = motion.status;
    if (motion.status == Status::NotFinite || motion.status == Status::NotAssemblable) {
        state.q.setConstant(kNone);
        state.qDot.setConstant(kNone);
        state.qDDot.setConstant(kNone);
        return state;
    }
    const double omega = m_mechanism.omega2();
    const double aCos = m_mechanism.a() * motion.crank.cos;
    const double aSin = m_mechanism.a() * motion.crank.sin;
    state.q << 0.0, 0.0, 0.0, 0.5 * aCos, 0.5 * aSin, motion.theta2, aCos + 0.5 * motion.s,
        0.5 * (aSin + m_mechanism.c()), motion.theta3, motion.R4x, m_mechanism.c(), 0.0;
    if (motion.status == Status::Singular) {
        state.qDot.setConstant(kNone);
        state.qDDot.setConstant(kNone);
        return state;
    }
    const double omegaSquared = omega * omega;
    state.qDot << 0.0, 0.0, 0.0, -0.5 * aSin * omega, 0.5 * aCos * omega, omega, -aSin * omega + 0.5 * motion.sDot,
        0.5 * aCos * omega, motion.theta3Dot, motion.R4xDot, 0.0, 0.0;
    state.qDDot << 0.0, 0.0, 0.0, -0.5 * aCos * omegaSquared, -0.5 * aSin * omegaSquared, 0.0,
        -aCos * omegaSquared + 0.5 * motion.sDDot, -0.5 * aSin * omegaSquared, motion.theta3DDot, motion.R4xDDot, 0.0,
        0.0;
    return state;
}

} // namespace slidercrank
