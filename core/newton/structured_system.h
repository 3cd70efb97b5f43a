// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The linear systems of Newton-Raphson, velocity and acceleration solved joint by joint instead of with a matrix: along
// the chain ground, drive, crank, slider's line, coupler, slider each constraint adds one unknown, but for the
// coupler's angle, which three rows together fix. The iterates are those of the dense elimination to rounding.
//
// All of it is defined here, so that the iteration is compiled as one piece: a step takes less time than passing its
// vectors through memory from one function to the next.
//
// Source: rows as in constraints.h; the derivations stand above next() and differentiate().
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"
#include "core/mechanism/two_part_angle.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace slidercrank
{

/// One Newton step, and velocity and acceleration, at one q at a time. Sines and cosines are taken once for each q
/// moved to.
class StructuredSystem
{
public:
    /// q, one number a name: the compiler keeps them in registers.
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

    /// q̇ of C_q q̇ = -C_t and q̈ of C_q q̈ = Q_d at the q moved to, into `state`. Whether they are finite.
    bool differentiate(State &state) const;

private:
    struct Rows {
        double groundX, groundY, groundAngle, crankPivotX, crankPivotY, crankPinX, crankPinY, sliderPinX, sliderPinY,
            sliderAngle, sliderLine, crankDrive;
    };
    void fillRows(const Coordinates &q);
    double excessOfTheta3() const;

    bool m_isCrossed;
    double m_halfA;
    double m_halfB;
    double m_c;
    double m_omega2;
    double m_drive;                                                  ///< ω2 t + θ20
    SinCos m_drivenCrank;                                            ///< of m_drive
    SinCos m_coupler;                                                ///< of θ3
    double m_movedTheta3 = std::numeric_limits<double>::quiet_NaN(); ///< of the last moveTo()
    bool m_isTurned = false;
    double m_crankX, m_crankY;     ///< (a/2) u(θ2)
    double m_couplerX, m_couplerY; ///< (b/2) u(θ3)
    Rows m_C;
};

inline StructuredSystem::StructuredSystem(const Mechanism &mechanism, double t)
    : m_isCrossed(mechanism.branch() == Branch::Crossed)
    , m_halfA(0.5 * mechanism.a())
    , m_halfB(0.5 * mechanism.b())
    , m_c(mechanism.c())
    , m_omega2(mechanism.omega2())
    , m_drive(mechanism.omega2() * t + mechanism.theta20())
    , m_drivenCrank{std::sin(m_drive), std::cos(m_drive)}
{
}

inline StructuredSystem::Coordinates StructuredSystem::coordinatesOf(const Vector12 &q)
{
    return {q[R1x], q[R1y], q[Theta1], q[R2x], q[R2y], q[Theta2], q[R3x], q[R3y], q[Theta3], q[R4x], q[R4y], q[Theta4]};
}

inline void StructuredSystem::write(const Coordinates &q, Vector12 &to)
{
    to << q.R1x, q.R1y, q.theta1, q.R2x, q.R2y, q.theta2, q.R3x, q.R3y, q.theta3, q.R4x, q.R4y, q.theta4;
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
//     sin (θ + δ) = sin θ + (cos θ sin δ - sin θ (1 - cos δ)),
//     cos (θ + δ) = cos θ - (sin θ sin δ + cos θ (1 - cos δ)),
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
    const bool isDriven = q.theta2 == m_drive;
    m_crankX = m_halfA * (isDriven ? m_drivenCrank.cos : std::cos(q.theta2));
    m_crankY = m_halfA * (isDriven ? m_drivenCrank.sin : std::sin(q.theta2));
    m_couplerX = m_halfB * m_coupler.cos;
    m_couplerY = m_halfB * m_coupler.sin;
    m_C.groundX = q.R1x;
    m_C.groundY = q.R1y;
    m_C.groundAngle = q.theta1;
    m_C.crankPivotX = q.R2x - m_crankX;
    m_C.crankPivotY = q.R2y - m_crankY;
    m_C.crankPinX = -q.R3x + q.R2x + m_crankX + m_couplerX;
    m_C.crankPinY = -q.R3y + q.R2y + m_crankY + m_couplerY;
    m_C.sliderPinX = q.R4x - q.R3x - m_couplerX;
    m_C.sliderPinY = q.R4y - q.R3y - m_couplerY;
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

inline Vector12 StructuredSystem::constraints() const
{
    const Rows &r = m_C;
    Vector12 C;
    C << r.groundX, r.groundY, r.groundAngle, r.crankPivotX, r.crankPivotY, r.crankPinX, r.crankPinY, r.sliderPinX,
        r.sliderPinY, r.sliderAngle, r.sliderLine, r.crankDrive;
    return C;
}

// C_q x = r, with (a/2) u(θ2) = (Ax, Ay) and (b/2) u(θ3) = (Bx, By). Nine rows give one unknown each as soon as those
// before it are known:
//
//     θ1 = r3      R1 = (r1, r2)      θ4 = r10 + θ1      θ2 = r12      R4y = r11
//     R2x = r4 - Ay θ2                R2y = r5 + Ax θ2
//
// θ3 and R3y are left in rows 7 and 9:
//
//     7:   R2y + Ax θ2 - R3y + Bx θ3 = r7
//     9:   R4y - R3y - Bx θ3 = r9
//
// Their difference is free of R3y, with the only pivot that is not 1 (det C_q is its negative); their sum is free of
// θ3, and with it of what θ3 loses where Bx is small:
//
//     2 Bx θ3 = (r7 - R2y - Ax θ2) - (r9 - R4y)
//     2 R3y   = (R2y + Ax θ2) + R4y - (r7 + r9)
//
// and then, each row in its turn,
//
//     6:   R3x = R2x - Ay θ2 - By θ3 - r6
//     8:   R4x = R3x - By θ3 + r8
inline double StructuredSystem::excessOfTheta3() const
{
    const double pinY = m_crankX * m_C.crankDrive;
    const double R2y = m_C.crankPivotY + pinY;
    return ((m_C.crankPinY - R2y - pinY) - (m_C.sliderPinY - m_C.sliderLine)) * (0.5 / m_couplerX);
}

inline StructuredSystem::Coordinates StructuredSystem::next(const Coordinates &q)
{
    if (m_isTurned) {
        moveTo(q); // the step is the dense one to rounding
    }
    const Rows &r = m_C;
    const double pinX = m_crankY * r.crankDrive;
    const double pinY = m_crankX * r.crankDrive;
    const double R2x = r.crankPivotX - pinX;
    const double R2y = r.crankPivotY + pinY;
    const double theta3 = excessOfTheta3();
    const double R3y = 0.5 * ((R2y + pinY) + r.sliderLine - (r.crankPinY + r.sliderPinY));
    const double couplerX = m_couplerY * theta3;
    const double R3x = R2x - pinX - couplerX - r.crankPinX;
    const double R4x = R3x - couplerX + r.sliderPinX;
    return {q.R1x - r.groundX, q.R1y - r.groundY,    q.theta1 - r.groundAngle,
            q.R2x - R2x,       q.R2y - R2y,          q.theta2 - r.crankDrive,
            q.R3x - R3x,       q.R3y - R3y,          q.theta3 - theta3,
            q.R4x - R4x,       q.R4y - r.sliderLine, q.theta4 - (r.sliderAngle + r.groundAngle)};
}

// Of -C_t only the drive's row is not 0: r12 = ω. So q̇ = ω q', where the elimination above leaves, for a drive of 1,
//
//     R2' = (-Ay, Ax)     Bx θ3' = -Ax     R3y' = Ax     R3x' = -2 Ay - By θ3'     R4x' = -2 Ay - 2 By θ3'
//
// Of Q_d rows 4 to 9 are not 0, where each ±(r) u(θ) of C leaves ±(r) θ̇² u(θ). So q̈ = ω² q'', where, with w = By θ3',
// and Bx θ3'² = -Ax θ3' by the line above,
//
//     r4, r5 = -Ax, -Ay     r6 = Ax - Ax θ3'     r7 = Ay + w θ3'     r8 = Ax θ3'     r9 = -w θ3'
//
// leave, with θ2'' = 0,
//
//     R2'' = (-Ax, -Ay)     Bx θ3'' = Ay + w θ3'     R3y'' = -Ay
//     R3x'' = Ax (θ3' - 2) - By θ3''     R4x'' = 2 (Ax (θ3' - 1) - By θ3'')
//
// A double near π is coarse, and π is none: on the crossed branch (Bx, By) is turned by what rounding took from θ3, as
// far as C tells.
inline bool StructuredSystem::differentiate(State &state) const
{
    const double Ax = m_crankX;
    const double Ay = m_crankY;
    double Bx = m_couplerX;
    double By = m_couplerY;
    if (m_isCrossed) {
        constexpr double kRounded = 1e-15; // rad: more is no rounding, but what the tolerance leaves
        const double told = excessOfTheta3();
        const double excess = std::abs(told) <= kRounded ? told : 0.0;
        Bx = m_couplerX + m_couplerY * excess;
        By = m_couplerY - m_couplerX * excess;
    }
    const double perBx = 1.0 / Bx;
    const double v = m_omega2;
    const double vSquared = v * v;

    const double theta3 = -Ax / Bx;
    const double w = By * theta3;
    state.qDot << 0.0, 0.0, 0.0, -Ay * v, Ax * v, v, (-2.0 * Ay - w) * v, Ax * v, theta3 * v, -2.0 * (Ay + w) * v, 0.0,
        0.0;

    const double theta3Next = (Ay + w * theta3) * perBx;
    const double turned = By * theta3Next;
    const double theta3DDot = theta3Next * vSquared;
    const double R3xDDot = (Ax * (theta3 - 2.0) - turned) * vSquared;
    const double R4xDDot = 2.0 * (Ax * (theta3 - 1.0) - turned) * vSquared;
    state.qDDot << 0.0, 0.0, 0.0, -Ax * vSquared, -Ay * vSquared, 0.0, R3xDDot, -Ay * vSquared, theta3DDot, R4xDDot,
        0.0, 0.0;

    // Each of the others is as large as one of these at most.
    return std::isfinite(theta3DDot) && std::isfinite(R3xDDot) && std::isfinite(R4xDDot);
}

} // namespace slidercrank
