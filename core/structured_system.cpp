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
    , m_drivenCrank{std::sin(m_drive), std::cos(m_drive)}
{
}

// θ2 is where the drive wants it from the second iterate on (its row is linear), or from the first.
void StructuredSystem::moveTo(const Vector12 &q)
{
    m_crank = q[Theta2] == m_drive ? m_drivenCrank : SinCos{std::sin(q[Theta2]), std::cos(q[Theta2])};
    m_coupler = {std::sin(q[Theta3]), std::cos(q[Theta3])};
    const double crankX = m_halfA * m_crank.cos;
    const double crankY = m_halfA * m_crank.sin;
    const double couplerX = m_halfB * m_coupler.cos;
    const double couplerY = m_halfB * m_coupler.sin;
    const double pivotX = q[R2x] - crankX;
    const double pivotY = q[R2y] - crankY;
    const double crankPinX = -q[R3x] + q[R2x] + crankX + couplerX;
    const double crankPinY = -q[R3y] + q[R2y] + crankY + couplerY;
    const double sliderPinX = q[R4x] - q[R3x] - couplerX;
    const double sliderPinY = q[R4y] - q[R3y] - couplerY;
    const double sliderAngle = q[Theta4] - q[Theta1];
    const double sliderLine = q[R4y] - m_c;
    const double drive = q[Theta2] - m_drive;
    m_C << q[R1x], q[R1y], q[Theta1], pivotX, pivotY, crankPinX, crankPinY, sliderPinX, sliderPinY, sliderAngle,
        sliderLine, drive;

    // Here, while they are in registers: the norm would otherwise cost as much as a sine.
    m_lengthsSquared =
        ((q[R1x] * q[R1x] + q[R1y] * q[R1y]) + (pivotX * pivotX + pivotY * pivotY)) +
        ((crankPinX * crankPinX + crankPinY * crankPinY) + (sliderPinX * sliderPinX + sliderPinY * sliderPinY)) +
        sliderLine * sliderLine;
    m_anglesSquared = q[Theta1] * q[Theta1] + sliderAngle * sliderAngle + drive * drive;
}

double StructuredSystem::residual(double perLength) const
{
    return std::sqrt(perLength * perLength * m_lengthsSquared + m_anglesSquared);
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
inline StructuredSystem::Columns StructuredSystem::solve(const Rows &r) const
{
    Columns x;
    x.R1x = r.groundX;
    x.R1y = r.groundY;
    x.theta1 = r.groundAngle;
    x.theta4 = r.sliderAngle + x.theta1;
    x.theta2 = r.crankDrive;
    x.R4y = r.sliderLine;

    const double crankX = m_halfA * m_crank.sin * x.theta2;
    const double crankY = m_halfA * m_crank.cos * x.theta2;
    x.R2x = r.crankPivotX - crankX;
    x.R2y = r.crankPivotY + crankY;

    const double couplerCos = m_halfB * m_coupler.cos;
    x.theta3 = ((r.crankPinY - x.R2y - crankY) - (r.sliderPinY - x.R4y)) / (2.0 * couplerCos);

    const double couplerX = m_halfB * m_coupler.sin * x.theta3;
    x.R3y = x.R4y - couplerCos * x.theta3 - r.sliderPinY;
    x.R3x = x.R2x - crankX - couplerX - r.crankPinX;
    x.R4x = x.R3x - couplerX + r.sliderPinX;
    return x;
}

Vector12 StructuredSystem::next(const Vector12 &q) const
{
    const Columns x = solve({-m_C[GroundX], -m_C[GroundY], -m_C[GroundAngle], -m_C[CrankPivotX], -m_C[CrankPivotY],
                             -m_C[CrankPinX], -m_C[CrankPinY], -m_C[SliderPinX], -m_C[SliderPinY], -m_C[SliderAngle],
                             -m_C[SliderLine], -m_C[CrankDrive]});
    Vector12 next;
    next << q[R1x] + x.R1x, q[R1y] + x.R1y, q[Theta1] + x.theta1, q[R2x] + x.R2x, q[R2y] + x.R2y, q[Theta2] + x.theta2,
        q[R3x] + x.R3x, q[R3y] + x.R3y, q[Theta3] + x.theta3, q[R4x] + x.R4x, q[R4y] + x.R4y, q[Theta4] + x.theta4;
    return next;
}

// -C_t and Q_d as in constraints.h: the drive is the only row with time in it, and each ±(r) u(θ) of C leaves
// ±(r) θ̇² u(θ) in Q_d.
bool StructuredSystem::differentiate(State &state) const
{
    Rows r{};
    r.crankDrive = m_omega2;
    const Columns v = solve(r);

    const double crankTerm = m_halfA * v.theta2 * v.theta2;
    const double couplerTerm = m_halfB * v.theta3 * v.theta3;
    r.crankDrive = 0.0;
    r.crankPivotX = -crankTerm * m_crank.cos;
    r.crankPivotY = -crankTerm * m_crank.sin;
    r.crankPinX = crankTerm * m_crank.cos + couplerTerm * m_coupler.cos;
    r.crankPinY = crankTerm * m_crank.sin + couplerTerm * m_coupler.sin;
    r.sliderPinX = -couplerTerm * m_coupler.cos;
    r.sliderPinY = -couplerTerm * m_coupler.sin;
    const Columns w = solve(r);
    state.qDot << v.R1x, v.R1y, v.theta1, v.R2x, v.R2y, v.theta2, v.R3x, v.R3y, v.theta3, v.R4x, v.R4y, v.theta4;
    state.qDDot << w.R1x, w.R1y, w.theta1, w.R2x, w.R2y, w.theta2, w.R3x, w.R3y, w.theta3, w.R4x, w.R4y, w.theta4;
    // Each of the others is as large as one of these at most.
    return std::isfinite(w.theta3) && std::isfinite(w.R3x) && std::isfinite(w.R3y) && std::isfinite(w.R4x);
}

} // namespace slidercrank
