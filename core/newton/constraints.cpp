// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/newton/constraints.h"

#include <cmath>

namespace slidercrank
{

// The centres of mass lie half way along crank and coupler, so with the unit vector u(θ) = (cos θ, sin θ):
//
//     ground      R1 = 0,  θ1 = 0
//     O2          R2 - (a/2) u(θ2) = 0
//     A           R2 + (a/2) u(θ2) + (b/2) u(θ3) - R3 = 0
//     B           R4 - R3 - (b/2) u(θ3) = 0
//     prismatic   θ4 - θ1 = 0,  R4y - c = 0
//     drive       θ2 - (ω2 t + θ20) = 0      (the sum first: then a double can satisfy it exactly, at any time)
Vector12 constraints(const Mechanism &mechanism, const Vector12 &q, double t)
{
    const double halfA = 0.5 * mechanism.a();
    const double halfB = 0.5 * mechanism.b();
    const double cos2 = std::cos(q[Theta2]);
    const double sin2 = std::sin(q[Theta2]);
    const double cos3 = std::cos(q[Theta3]);
    const double sin3 = std::sin(q[Theta3]);

    Vector12 C;
    C[GroundX] = q[R1x];
    C[GroundY] = q[R1y];
    C[GroundAngle] = q[Theta1];
    C[CrankPivotX] = q[R2x] - halfA * cos2;
    C[CrankPivotY] = q[R2y] - halfA * sin2;
    C[CrankPinX] = -q[R3x] + q[R2x] + halfA * cos2 + halfB * cos3;
    C[CrankPinY] = -q[R3y] + q[R2y] + halfA * sin2 + halfB * sin3;
    C[SliderPinX] = q[R4x] - q[R3x] - halfB * cos3;
    C[SliderPinY] = q[R4y] - q[R3y] - halfB * sin3;
    C[SliderAngle] = q[Theta4] - q[Theta1];
    C[SliderLine] = q[R4y] - mechanism.c();
    C[CrankDrive] = q[Theta2] - (mechanism.omega2() * t + mechanism.theta20());
    return C;
}

// du/dθ = (-sin θ, cos θ); everything else in C is linear in q.
Matrix12 constraintJacobian(const Mechanism &mechanism, const Vector12 &q)
{
    const double halfA = 0.5 * mechanism.a();
    const double halfB = 0.5 * mechanism.b();
    const double cos2 = std::cos(q[Theta2]);
    const double sin2 = std::sin(q[Theta2]);
    const double cos3 = std::cos(q[Theta3]);
    const double sin3 = std::sin(q[Theta3]);

    Matrix12 Cq = Matrix12::Zero();
    Cq(GroundX, R1x) = 1.0;
    Cq(GroundY, R1y) = 1.0;
    Cq(GroundAngle, Theta1) = 1.0;

    Cq(CrankPivotX, R2x) = 1.0;
    Cq(CrankPivotX, Theta2) = halfA * sin2;
    Cq(CrankPivotY, R2y) = 1.0;
    Cq(CrankPivotY, Theta2) = -halfA * cos2;

    Cq(CrankPinX, R2x) = 1.0;
    Cq(CrankPinX, Theta2) = -halfA * sin2;
    Cq(CrankPinX, R3x) = -1.0;
    Cq(CrankPinX, Theta3) = -halfB * sin3;
    Cq(CrankPinY, R2y) = 1.0;
    Cq(CrankPinY, Theta2) = halfA * cos2;
    Cq(CrankPinY, R3y) = -1.0;
    Cq(CrankPinY, Theta3) = halfB * cos3;

    Cq(SliderPinX, R4x) = 1.0;
    Cq(SliderPinX, R3x) = -1.0;
    Cq(SliderPinX, Theta3) = halfB * sin3;
    Cq(SliderPinY, R4y) = 1.0;
    Cq(SliderPinY, R3y) = -1.0;
    Cq(SliderPinY, Theta3) = -halfB * cos3;

    Cq(SliderAngle, Theta4) = 1.0;
    Cq(SliderAngle, Theta1) = -1.0;
    Cq(SliderLine, R4y) = 1.0;
    Cq(CrankDrive, Theta2) = 1.0;
    return Cq;
}

// Time appears in the drive alone.
Vector12 constraintTimeDerivative(const Mechanism &mechanism)
{
    Vector12 Ct = Vector12::Zero();
    Ct[CrankDrive] = -mechanism.omega2();
    return Ct;
}

// C_qt = 0 and C_tt = 0, so only -(C_q q̇)_q q̇ is left. Of C_q q̇ the terms that depend on q are those with u'(θ) θ̇, and
// u''(θ) = -u(θ): each ±(r) u(θ) of C leaves ±(r) θ̇² u(θ) here.
Vector12 quadraticVelocityTerm(const Mechanism &mechanism, const Vector12 &q, const Vector12 &qDot)
{
    const double crankTerm = 0.5 * mechanism.a() * qDot[Theta2] * qDot[Theta2];
    const double couplerTerm = 0.5 * mechanism.b() * qDot[Theta3] * qDot[Theta3];
    const double cos2 = std::cos(q[Theta2]);
    const double sin2 = std::sin(q[Theta2]);
    const double cos3 = std::cos(q[Theta3]);
    const double sin3 = std::sin(q[Theta3]);

    Vector12 Qd = Vector12::Zero();
    Qd[CrankPivotX] = -crankTerm * cos2;
    Qd[CrankPivotY] = -crankTerm * sin2;
    Qd[CrankPinX] = crankTerm * cos2 + couplerTerm * cos3;
    Qd[CrankPinY] = crankTerm * sin2 + couplerTerm * sin3;
    Qd[SliderPinX] = -couplerTerm * cos3;
    Qd[SliderPinY] = -couplerTerm * sin3;
    return Qd;
}

double residualInUnits(const Vector12 &C, double perLength, double unit)
{
    Vector12 lengths = unit * C;
    Vector12 angles = Vector12::Zero();
    for (const Constraint row : {GroundAngle, SliderAngle, CrankDrive}) {
        lengths[row] = 0.0;
        angles[row] = C[row];
    }
    return std::hypot(perLength * lengths.norm(), angles.norm());
}

} // namespace slidercrank
