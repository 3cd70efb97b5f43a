// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The linear systems of Newton-Raphson, velocity and acceleration solved joint by joint instead of with a matrix: along
// the chain ground, drive, crank, slider's line, coupler, slider each constraint adds one unknown, but for the
// coupler's angle, which three rows together fix. The iterates are those of the dense elimination to rounding.
//
// All of it is defined here, so that the iteration is compiled as one piece: a step takes less time than passing its
// vectors through memory from one function to the next.
//
// Source: rows as in constraints.h; the derivation stands above solve().
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism.h"
#include "core/two_part_angle.h"

#include <cmath>
#include <limits>

namespace slidercrank
{

/// One Newton step, and velocity and acceleration, at one q at a time. Sines and cosines are taken once for each q
/// moved to.
class StructuredSystem
{
public:
    /// q, or what is added to it, one number a name: the compiler keeps them in registers.
    struct Coordinates {
        double R1x, R1y, theta1, R2x, R2y, theta2, R3x, R3y, theta3, R4x, R4y, theta4;
    };
    static Coordinates coordinatesOf(const Vector12 &q);
    static void write(const Coordinates &q, Vector12 &to);

    StructuredSystem(const Mechanism &mechanism, double t);

    void moveTo(const Coordinates &q);

    /// The same for a q that may well be the last: where θ3 is close to the one before, its sine and cosine are turned
    /// there, which costs less than taking them anew and adds a rounding.
    void turnTo(const Coordinates &q);

    /// C(q, t): that of constraints(), to the last bit after moveTo(), to rounding after turnTo().
    Vector12 constraints() const;

    /// ‖C‖ with the length rows multiplied by `perLength`.
    double residual(double perLength) const;

    /// q + Δq with C_q Δq = -C, for the q moved or turned to, moved to in any case. Not finite where the coupler stands
    /// square (cos θ3 = 0).
    Coordinates next(const Coordinates &q);

    double cosTheta3() const { return m_coupler.cos; }

    /// q̇ of C_q q̇ = -C_t and q̈ of C_q q̈ = Q_d, into `state`, whose q is the one moved to. Whether they are finite.
    bool differentiate(State &state) const;

private:
    /// C, or a right-hand side.
    struct Rows {
        double groundX, groundY, groundAngle, crankPivotX, crankPivotY, crankPinX, crankPinY, sliderPinX, sliderPinY,
            sliderAngle, sliderLine, crankDrive;
    };
    Coordinates solve(const Rows &r) const;
    void fillRows(const Coordinates &q);

    double m_halfA;
    double m_halfB;
    double m_c;
    double m_omega2;
    double m_drive;                                                  ///< ω2 t + θ20
    SinCos m_drivenCrank;                                            ///< of m_drive
    SinCos m_crank;                                                  ///< of θ2
    SinCos m_coupler;                                                ///< of θ3
    double m_movedTheta3 = std::numeric_limits<double>::quiet_NaN(); ///< of the last moveTo()
    bool m_isTurned = false;
    Rows m_C;
};

inline StructuredSystem::StructuredSystem(const Mechanism &mechanism, double t)
    : m_halfA(0.5 * mechanism.a())
    , m_halfB(0.5 * mechanism.b())
    , m_c(mechanism.c())
    , m_omega2(mechanism.omega2())
    , m_drive(mechanism.omega2() * t + mechanism.theta20())
    , m_drivenCrank{std::sin(m_drive), std::cos(m_drive)}
{
}

inline void StructuredSystem::moveTo(const Coordinates &q)
{
    m_movedTheta3 = q.theta3;
    m_isTurned = false;
    const double sine = std::sin(q.theta3);
    const double cosine = std::cos(q.theta3);
    m_coupler = {sine, cosine};
    fillRows(q);
}

// By a small angle δ,
//
//     sin (θ + δ) = sin θ + (cos θ sin δ - sin θ (1 - cos δ)),  cos (θ + δ) = cos θ - (sin θ sin δ + cos θ (1 - cos
//     δ)),
//
// where the terms in brackets are so small that only the sums round.
inline void StructuredSystem::turnTo(const Coordinates &q)
{
    constexpr double kSmallTurn = 0x1p-11; // rad; δ⁵/120, the first term left out, is then below 3e-19
    const double turn = q.theta3 - m_movedTheta3;
    constexpr double kSquare = 0.125; // |cos θ3| below which the derivatives, up to its -3rd power, want every digit
    if (m_isTurned || !(std::abs(turn) <= kSmallTurn) || std::abs(m_coupler.cos) < kSquare) { // also for NaN
        moveTo(q);
        return;
    }
    m_isTurned = true;
    const double square = turn * turn;
    const double turnSine = turn - turn * square * (1.0 / 6.0);
    const double turnFall = square * (0.5 - square * (1.0 / 24.0));
    const double sine = m_coupler.sin + (m_coupler.cos * turnSine - m_coupler.sin * turnFall);
    const double cosine = m_coupler.cos - (m_coupler.sin * turnSine + m_coupler.cos * turnFall);
    m_coupler = {sine, cosine};
    fillRows(q);
}

// θ2 is where the drive wants it from the second iterate on (its row is linear), or from the first.
inline void StructuredSystem::fillRows(const Coordinates &q)
{
    if (q.theta2 == m_drive) {
        m_crank.sin = m_drivenCrank.sin;
        m_crank.cos = m_drivenCrank.cos;
    } else {
        m_crank.sin = std::sin(q.theta2);
        m_crank.cos = std::cos(q.theta2);
    }
    const double crankX = m_halfA * m_crank.cos;
    const double crankY = m_halfA * m_crank.sin;
    const double couplerX = m_halfB * m_coupler.cos;
    const double couplerY = m_halfB * m_coupler.sin;
    m_C.groundX = q.R1x;
    m_C.groundY = q.R1y;
    m_C.groundAngle = q.theta1;
    m_C.crankPivotX = q.R2x - crankX;
    m_C.crankPivotY = q.R2y - crankY;
    m_C.crankPinX = -q.R3x + q.R2x + crankX + couplerX;
    m_C.crankPinY = -q.R3y + q.R2y + crankY + couplerY;
    m_C.sliderPinX = q.R4x - q.R3x - couplerX;
    m_C.sliderPinY = q.R4y - q.R3y - couplerY;
    m_C.sliderAngle = q.theta4 - q.theta1;
    m_C.sliderLine = q.R4y - m_c;
    m_C.crankDrive = q.theta2 - m_drive;
}

inline double StructuredSystem::residual(double perLength) const
{
    const Rows &r = m_C;
    const double lengthsSquared = ((r.groundX * r.groundX + r.groundY * r.groundY) +
                                   (r.crankPivotX * r.crankPivotX + r.crankPivotY * r.crankPivotY)) +
                                  ((r.crankPinX * r.crankPinX + r.crankPinY * r.crankPinY) +
                                   (r.sliderPinX * r.sliderPinX + r.sliderPinY * r.sliderPinY)) +
                                  r.sliderLine * r.sliderLine;
    const double anglesSquared =
        r.groundAngle * r.groundAngle + r.sliderAngle * r.sliderAngle + r.crankDrive * r.crankDrive;
    return std::sqrt(perLength * perLength * lengthsSquared + anglesSquared);
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
inline StructuredSystem::Coordinates StructuredSystem::solve(const Rows &r) const
{
    Coordinates x;
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

inline Vector12 StructuredSystem::constraints() const
{
    const Rows &r = m_C;
    Vector12 C;
    C << r.groundX, r.groundY, r.groundAngle, r.crankPivotX, r.crankPivotY, r.crankPinX, r.crankPinY, r.sliderPinX,
        r.sliderPinY, r.sliderAngle, r.sliderLine, r.crankDrive;
    return C;
}

inline StructuredSystem::Coordinates StructuredSystem::coordinatesOf(const Vector12 &q)
{
    return {q[R1x], q[R1y], q[Theta1], q[R2x], q[R2y], q[Theta2], q[R3x], q[R3y], q[Theta3], q[R4x], q[R4y], q[Theta4]};
}

inline void StructuredSystem::write(const Coordinates &q, Vector12 &to)
{
    to << q.R1x, q.R1y, q.theta1, q.R2x, q.R2y, q.theta2, q.R3x, q.R3y, q.theta3, q.R4x, q.R4y, q.theta4;
}

inline StructuredSystem::Coordinates StructuredSystem::next(const Coordinates &q)
{
    if (m_isTurned) {
        moveTo(q); // the step is the dense one to rounding
    }
    const Coordinates x =
        solve({-m_C.groundX, -m_C.groundY, -m_C.groundAngle, -m_C.crankPivotX, -m_C.crankPivotY, -m_C.crankPinX,
               -m_C.crankPinY, -m_C.sliderPinX, -m_C.sliderPinY, -m_C.sliderAngle, -m_C.sliderLine, -m_C.crankDrive});
    return {q.R1x + x.R1x, q.R1y + x.R1y, q.theta1 + x.theta1, q.R2x + x.R2x, q.R2y + x.R2y, q.theta2 + x.theta2,
            q.R3x + x.R3x, q.R3y + x.R3y, q.theta3 + x.theta3, q.R4x + x.R4x, q.R4y + x.R4y, q.theta4 + x.theta4};
}

// -C_t and Q_d as in constraints.h: the drive is the only row with time in it, and each ±(r) u(θ) of C leaves
// ±(r) θ̇² u(θ) in Q_d.
inline bool StructuredSystem::differentiate(State &state) const
{
    Rows r{};
    r.crankDrive = m_omega2;
    const Coordinates v = solve(r);

    const double crankTerm = m_halfA * v.theta2 * v.theta2;
    const double couplerTerm = m_halfB * v.theta3 * v.theta3;
    r.crankDrive = 0.0;
    r.crankPivotX = -crankTerm * m_crank.cos;
    r.crankPivotY = -crankTerm * m_crank.sin;
    r.crankPinX = crankTerm * m_crank.cos + couplerTerm * m_coupler.cos;
    r.crankPinY = crankTerm * m_crank.sin + couplerTerm * m_coupler.sin;
    r.sliderPinX = -couplerTerm * m_coupler.cos;
    r.sliderPinY = -couplerTerm * m_coupler.sin;
    const Coordinates w = solve(r);
    write(v, state.qDot);
    write(w, state.qDDot);
    // Each of the others is as large as one of these at most.
    return std::isfinite(w.theta3) && std::isfinite(w.R3x) && std::isfinite(w.R3y) && std::isfinite(w.R4x);
}

} // namespace slidercrank
