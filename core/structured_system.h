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

/// C, and the solution of C_q x = r, at one q at a time. Sines and cosines are taken once for each q.
class StructuredSystem
{
public:
    StructuredSystem(const Mechanism &mechanism, double t);

    void moveTo(const Vector12 &q);

    /// C(q, t), the same to the last bit as constraints().
    const Vector12 &constraints() const { return m_C; }

    /// Δq of C_q Δq = -C. Not finite where the coupler stands square (cos θ3 = 0).
    Vector12 step() const { return solve(-m_C); }

    double cosTheta3() const { return m_coupler.cos; }

    /// q̇ of C_q q̇ = -C_t and q̈ of C_q q̈ = Q_d, into `state`.
    void differentiate(State &state) const;

private:
    Vector12 solve(const Vector12 &r) const;

    double m_halfA;
    double m_halfB;
    double m_c;
    double m_omega2;
    double m_drive;   ///< ω2 t + θ20
    double m_theta2;  ///< of m_crank, rad
    SinCos m_crank;   ///< of θ2
    SinCos m_coupler; ///< of θ3
    Vector12 m_C;
};

} // namespace slidercrank
