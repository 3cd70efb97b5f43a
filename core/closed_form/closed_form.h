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

namespace slidercrank
{

struct State;

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

    /// All 36 channels at time t (s): state_at.h.
    inline State stateAt(double t) const;

private:
    /// By the standard library's functions, for what the kernel leaves: an instant that is not Solved, one near a
    /// limit of a rocker, or one whose angle is too large for its reduction.
    Motion motionStepByStep(double t) const;

    Mechanism m_mechanism;
    Clearance m_clearance;
    MotionConstants m_constants;
};

} // namespace slidercrank
