// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The linear systems of Newton-Raphson, velocity and acceleration solved joint by joint instead of with a matrix: along
// the chain ground, drive, crank, slider's line, coupler, slider each constraint adds one unknown, but for the
// coupler's angle, which three rows together fix. The iterates are those of the dense elimination to rounding.
//
// Source: rows as in constraints.h; the derivation stands above solve() in structured_system.cpp.
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism.h"
#include "core/two_part_angle.h"

namespace slidercrank
{

/// One Newton step, and velocity and acceleration, at one q at a time. Sines and cosines are taken once for each q.
class StructuredSystem
{
public:
    StructuredSystem(const Mechanism &mechanism, double t);

    void moveTo(const Vector12 &q);

    /// C(q, t), the same to the last bit as constraints().
    const Vector12 &constraints() const { return m_C; }

    /// ‖C‖ with the length rows multiplied by `perLength`.
    double residual(double perLength) const;

    /// q + Δq with C_q Δq = -C, for the q moved to. Not finite where the coupler stands square (cos θ3 = 0).
    Vector12 next(const Vector12 &q) const;

    double cosTheta3() const { return m_coupler.cos; }

    /// q̇ of C_q q̇ = -C_t and q̈ of C_q q̈ = Q_d, into `state`, whose q is the one moved to. Whether they are finite.
    bool differentiate(State &state) const;

private:
    /// A right-hand side, or a solution, one number a name: the compiler keeps them in registers.
    struct Rows {
        double groundX, groundY, groundAngle, crankPivotX, crankPivotY, crankPinX, crankPinY, sliderPinX, sliderPinY,
            sliderAngle, sliderLine, crankDrive;
    };
    struct Columns {
        double R1x, R1y, theta1, R2x, R2y, theta2, R3x, R3y, theta3, R4x, R4y, theta4;
    };
    Columns solve(const Rows &r) const;

    double m_halfA;
    double m_halfB;
    double m_c;
    double m_omega2;
    double m_drive;       ///< ω2 t + θ20
    SinCos m_drivenCrank; ///< of m_drive
    SinCos m_crank;       ///< of θ2
    SinCos m_coupler;     ///< of θ3
    Vector12 m_C;
    double m_lengthsSquared; ///< of the length rows of C
    double m_anglesSquared;
};

} // namespace slidercrank
