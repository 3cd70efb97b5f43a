// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/newton/constraints.h"

#include <cmath>

namespace slidercrank
{

namespace
{

/// The vectors from an end of a link to its centre of mass: (a/2) u(θ2) and (b/2) u(θ3), with u(θ) = (cos θ, sin θ).
struct HalfLinks {
    double crankX, crankY, couplerX, couplerY;

    HalfLinks(const Mechanism &mechanism, const Vector12 &q)
        : crankX(0.5 * mechanism.a() * std::cos(q[Theta2]))
        , crankY(0.5 * mechanism.a() * std::sin(q[Theta2]))
        , couplerX(0.5 * mechanism.b() * std::cos(q[Theta3]))
        , couplerY(0.5 * mechanism.b() * std::sin(q[Theta3]))
    {
    }
};

} // namespace

// The centres of mass are the midpoints of crank and coupler, so with the unit vector u(θ) = (cos θ, sin θ):
//
//     ground      R1 = 0,  θ1 = 0
//     O2          R2 - (a/2) u(θ2) = 0
//     A           R2 + (a/2) u(θ2) + (b/2) u(θ3) - R3 = 0
//     B           R4 - R3 - (b/2) u(θ3) = 0
//     prismatic   θ4 - θ1 = 0,  R4y - c = 0
//     drive       θ2 - (ω2 t + θ20) = 0      (the sum is rounded first, so that a double can satisfy the row exactly)
Vector12 constraints(const Mechanism &mechanism, const Vector12 &q, double t)
{
    const HalfLinks half(mechanism, q);
    Vector12 C;
    C[GroundX] = q[R1x];
    C[GroundY] = q[R1y];
    C[GroundAngle] = q[Theta1];
    C[CrankPivotX] = q[R2x] - half.crankX;
    C[CrankPivotY] = q[R2y] - half.crankY;
    C[CrankPinX] = -q[R3x] + q[R2x] + half.crankX + half.couplerX;
    C[CrankPinY] = -q[R3y] + q[R2y] + half.crankY + half.couplerY;
    C[SliderPinX] = q[R4x] - q[R3x] - half.couplerX;
    C[SliderPinY] = q[R4y] - q[R3y] - half.couplerY;
    C[SliderAngle] = q[Theta4] - q[Theta1];
    C[SliderLine] = q[R4y] - mechanism.c();
    C[CrankDrive] = q[Theta2] - (mechanism.omega2() * t + mechanism.theta20());
    return C;
}

// du/dθ = (-sin θ, cos θ); everything else in C is linear in q.
Matrix12 constraintJacobian(const Mechanism &mechanism, const Vector12 &q)
{
    const HalfLinks half(mechanism, q);
    Matrix12 Cq = Matrix12::Zero();
    Cq(GroundX, R1x) = 1.0;
    Cq(GroundY, R1y) = 1.0;
    Cq(GroundAngle, Theta1) = 1.0;

    Cq(CrankPivotX, R2x) = 1.0;
    Cq(CrankPivotX, Theta2) = half.crankY;
    Cq(CrankPivotY, R2y) = 1.0;
    Cq(CrankPivotY, Theta2) = -half.crankX;

    Cq(CrankPinX, R2x) = 1.0;
    Cq(CrankPinX, Theta2) = -half.crankY;
    Cq(CrankPinX, R3x) = -1.0;
    Cq(CrankPinX, Theta3) = -half.couplerY;
    Cq(CrankPinY, R2y) = 1.0;
    Cq(CrankPinY, Theta2) = half.crankX;
    Cq(CrankPinY, R3y) = -1.0;
    Cq(CrankPinY, Theta3) = half.couplerX;

    Cq(SliderPinX, R4x) = 1.0;
    Cq(SliderPinX, R3x) = -1.0;
    Cq(SliderPinX, Theta3) = half.couplerY;
    Cq(SliderPinY, R4y) = 1.0;
    Cq(SliderPinY, R3y) = -1.0;
    Cq(SliderPinY, Theta3) = -half.couplerX;

    Cq(SliderAngle, Theta4) = 1.0;
    Cq(SliderAngle, Theta1) = -1.0;
    Cq(SliderLine, R4y) = 1.0;
    Cq(CrankDrive, Theta2) = 1.0;
    return Cq;
}

// Time occurs only in the row of the drive.
Vector12 constraintTimeDerivative(const Mechanism &mechanism)
{
    Vector12 Ct = Vector12::Zero();
    Ct[CrankDrive] = -mechanism.omega2();
    return Ct;
}

// C_qt = 0 and C_tt = 0, which leaves -(C_q q̇)_q q̇. The terms of C_q q̇ that depend on q are those with u'(θ) θ̇, and
// u''(θ) = -u(θ): each term ±(r) u(θ) of C becomes ±(r) θ̇² u(θ) here.
Vector12 quadraticVelocityTerm(const Mechanism &mechanism, const Vector12 &q, const Vector12 &qDot)
{
    const HalfLinks half(mechanism, q);
    const double crankSquared = qDot[Theta2] * qDot[Theta2];
    const double couplerSquared = qDot[Theta3] * qDot[Theta3];
    Vector12 Qd = Vector12::Zero();
    Qd[CrankPivotX] = -crankSquared * half.crankX;
    Qd[CrankPivotY] = -crankSquared * half.crankY;
    Qd[CrankPinX] = crankSquared * half.crankX + couplerSquared * half.couplerX;
    Qd[CrankPinY] = crankSquared * half.crankY + couplerSquared * half.couplerY;
    Qd[SliderPinX] = -couplerSquared * half.couplerX;
    Qd[SliderPinY] = -couplerSquared * half.couplerY;
    return Qd;
}

} // namespace slidercrank
