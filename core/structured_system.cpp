// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structured_system.h"

#include <cmath>

namespace slidercrank
{

StructuredSystem::StructuredSystem(const Mechanism &mechanism, double t)
    : m_halfA(0.5 * mechanism.a())
    , m_halfB(0.5 * mechanism.b())
    , m_c(mechanism.c())
    , m_omega2(mechanism.omega2())
    , m_drive(mechanism.omega2() * t + mechanism.theta20())
    , m_theta2(m_drive)
    , m_crank{std::sin(m_drive), std::cos(m_drive)}
{
}

// θ2 stands still from the second iterate on (its row is linear), so that its sine and cosine need not be taken again.
void StructuredSystem::moveTo(const Vector12 &q)
{
    if (q[Theta2] != m_theta2) {
        m_theta2 = q[Theta2];
        m_crank = {std::sin(m_theta2), std::cos(m_theta2)};
    }
    m_coupler = {std::sin(q[Theta3]), std::cos(q[Theta3])};
    m_C[GroundX] = q[R1x];
    m_C[GroundY] = q[R1y];
    m_C[GroundAngle] = q[Theta1];
    m_C[CrankPivotX] = q[R2x] - m_halfA * m_crank.cos;
    m_C[CrankPivotY] = q[R2y] - m_halfA * m_crank.sin;
    m_C[CrankPinX] = -q[R3x] + q[R2x] + m_halfA * m_crank.cos + m_halfB * m_coupler.cos;
    m_C[CrankPinY] = -q[R3y] + q[R2y] + m_halfA * m_crank.sin + m_halfB * m_coupler.sin;
    m_C[SliderPinX] = q[R4x] - q[R3x] - m_halfB * m_coupler.cos;
    m_C[SliderPinY] = q[R4y] - q[R3y] - m_halfB * m_coupler.sin;
    m_C[SliderAngle] = q[Theta4] - q[Theta1];
    m_C[SliderLine] = q[R4y] - m_c;
    m_C[CrankDrive] = q[Theta2] - m_drive;
}

// C_q x = r, with s_i, c_i for sin θi, cos θi. Nine rows give one unknown each as soon as those before it are known:
//
//     θ1 = r3      R1 = (r1, r2)      θ4 = r10 + θ1      θ2 = r12      R4y = r11
//     R2x + (a/2) s2 θ2 = r4          R2y - (a/2) c2 θ2 = r5
//
// θ3 and R3y are left in rows 7 and 9:
//
//     7:   R2y + (a/2) c2 θ2 - R3y + (b/2) c3 θ3 = r7
//     9:   R4y - R3y - (b/2) c3 θ3 = r9
//
// Their difference is free of R3y, with the only pivot that is not 1 (det C_q is its negative):
//
//     b c3 θ3 = (r7 - R2y - (a/2) c2 θ2) - (r9 - R4y)
//
// and then, each row in its turn,
//
//     9:   R3y = R4y - (b/2) c3 θ3 - r9
//     6:   R3x = R2x - (a/2) s2 θ2 - (b/2) s3 θ3 - r6
//     8:   R4x = R3x - (b/2) s3 θ3 + r8
Vector12 StructuredSystem::solve(const Vector12 &r) const
{
    Vector12 x;
    x[R1x] = r[GroundX];
    x[R1y] = r[GroundY];
    x[Theta1] = r[GroundAngle];
    x[Theta4] = r[SliderAngle] + x[Theta1];
    x[Theta2] = r[CrankDrive];
    x[R4y] = r[SliderLine];

    const double crankX = m_halfA * m_crank.sin * x[Theta2];
    const double crankY = m_halfA * m_crank.cos * x[Theta2];
    x[R2x] = r[CrankPivotX] - crankX;
    x[R2y] = r[CrankPivotY] + crankY;

    const double pivot = 2.0 * m_halfB * m_coupler.cos;
    x[Theta3] = ((r[CrankPinY] - x[R2y] - crankY) - (r[SliderPinY] - x[R4y])) / pivot;

    const double couplerX = m_halfB * m_coupler.sin * x[Theta3];
    const double couplerY = m_halfB * m_coupler.cos * x[Theta3];
    x[R3y] = x[R4y] - couplerY - r[SliderPinY];
    x[R3x] = x[R2x] - crankX - couplerX - r[CrankPinX];
    x[R4x] = x[R3x] - couplerX + r[SliderPinX];
    return x;
}

// -C_t and Q_d as in constraints.h: the drive is the only row with time in it, and each ±(r) u(θ) of C leaves
// ±(r) θ̇² u(θ) in Q_d.
void StructuredSystem::differentiate(State &state) const
{
    Vector12 r = Vector12::Zero();
    r[CrankDrive] = m_omega2;
    state.qDot = solve(r);

    const double crankTerm = m_halfA * state.qDot[Theta2] * state.qDot[Theta2];
    const double couplerTerm = m_halfB * state.qDot[Theta3] * state.qDot[Theta3];
    r[CrankDrive] = 0.0;
    r[CrankPivotX] = -crankTerm * m_crank.cos;
    r[CrankPivotY] = -crankTerm * m_crank.sin;
    r[CrankPinX] = crankTerm * m_crank.cos + couplerTerm * m_coupler.cos;
    r[CrankPinY] = crankTerm * m_crank.sin + couplerTerm * m_coupler.sin;
    r[SliderPinX] = -couplerTerm * m_coupler.cos;
    r[SliderPinY] = -couplerTerm * m_coupler.sin;
    state.qDDot = solve(r);
}

} // namespace slidercrank
