// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/newton/constraints.h"

#include <cmath>

namespace slidercrank
{

namespace
{

// The centres of mass are the midpoints of crank and coupler, so with the unit vector u(θ) = (cos θ, sin θ):
//
//     ground      R1 = 0,  θ1 = 0
//     O2          R2 - (a/2) u(θ2) = 0
//     A           R2 + (a/2) u(θ2) + (b/2) u(θ3) - R3 = 0
//     B           R4 - R3 - (b/2) u(θ3) = 0
//     prismatic   θ4 - θ1 = 0,  R4y - c = 0
//     drive       θ2 - (ω2 t + θ20) = 0      (the sum is rounded first, so that a double can satisfy the row exactly)

/// A term `sign` q[coordinate] of a row of C.
struct LinearTerm {
    Constraint row;
    Coordinate coordinate;
    double sign = 1.0;
};

/// The terms of the joints in the x rows. The y rows have the same terms, with the next row and the next coordinate.
constexpr LinearTerm kJointTerms[] = {{GroundX, R1x},   {CrankPivotX, R2x}, {CrankPinX, R3x, -1.0},
                                      {CrankPinX, R2x}, {SliderPinX, R4x},  {SliderPinX, R3x, -1.0}};

constexpr LinearTerm kOtherTerms[] = {
    {GroundAngle, Theta1}, {SliderAngle, Theta4}, {SliderAngle, Theta1, -1.0}, {SliderLine, R4y}, {CrankDrive, Theta2}};

/// The crank or the coupler. The vector half the length times u(θ) occurs in the rows of both joints of the link:
/// positive at the crank pin A, negative at the other joint.
struct Link {
    Coordinate angle;
    Constraint otherJointX;

    /// Returns half the length times u(θ).
    Eigen::Vector2d half(const Mechanism &mechanism, const Vector12 &q) const
    {
        const double length = angle == Theta2 ? mechanism.a() : mechanism.b();
        return {0.5 * length * std::cos(q[angle]), 0.5 * length * std::sin(q[angle])};
    }
};

constexpr Link kLinks[] = {{Theta2, CrankPivotX}, {Theta3, SliderPinX}};

} // namespace

Vector12 constraints(const Mechanism &mechanism, const Vector12 &q, double t)
{
    Vector12 C = Vector12::Zero();
    for (const auto &[row, coordinate, sign] : kJointTerms) {
        C.segment<2>(row) += sign * q.segment<2>(coordinate);
    }
    for (const auto &[row, coordinate, sign] : kOtherTerms) {
        C[row] += sign * q[coordinate];
    }
    for (const Link &link : kLinks) {
        const Eigen::Vector2d half = link.half(mechanism, q);
        C.segment<2>(CrankPinX) += half;
        C.segment<2>(link.otherJointX) -= half;
    }
    C[SliderLine] -= mechanism.c();
    C[CrankDrive] -= mechanism.omega2() * t + mechanism.theta20();
    return C;
}

// du/dθ = (-sin θ, cos θ); everything else in C is linear in q.
Matrix12 constraintJacobian(const Mechanism &mechanism, const Vector12 &q)
{
    Matrix12 Cq = Matrix12::Zero();
    for (const auto &[row, coordinate, sign] : kJointTerms) {
        Cq(row, coordinate) = Cq(row + 1, coordinate + 1) = sign;
    }
    for (const auto &[row, coordinate, sign] : kOtherTerms) {
        Cq(row, coordinate) = sign;
    }
    for (const Link &link : kLinks) {
        const Eigen::Vector2d half = link.half(mechanism, q);
        const Eigen::Vector2d derivative{-half.y(), half.x()};
        Cq.block<2, 1>(CrankPinX, link.angle) = derivative;
        Cq.block<2, 1>(link.otherJointX, link.angle) = -derivative;
    }
    return Cq;
}

// Time occurs only in the row of the drive.
Vector12 constraintTimeDerivative(const Mechanism &mechanism)
{
    Vector12 Ct = Vector12::Zero();
    Ct[CrankDrive] = -mechanism.omega2();
    return Ct;
}

// C_qt = 0 and C_tt = 0, which leaves -(C_q q̇)_q q̇. Only the terms u'(θ) θ̇ of C_q q̇ depend on q, and
// u''(θ) = -u(θ): each term ±(r) u(θ) of C becomes ±(r) θ̇² u(θ) here.
Vector12 quadraticVelocityTerm(const Mechanism &mechanism, const Vector12 &q, const Vector12 &qDot)
{
    Vector12 Qd = Vector12::Zero();
    for (const Link &link : kLinks) {
        const Eigen::Vector2d term = qDot[link.angle] * qDot[link.angle] * link.half(mechanism, q);
        Qd.segment<2>(CrankPinX) += term;
        Qd.segment<2>(link.otherJointX) -= term;
    }
    return Qd;
}

} // namespace slidercrank
