// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Solves the linear systems of position, velocity and acceleration joint by joint instead of with a matrix. Along
// the chain ground, drive, crank, slider's line, coupler, slider each constraint adds one unknown, except that three
// rows together determine the angle of the coupler. The iterates equal those of the dense elimination to rounding.
//
// Everything is defined in this header, so that the iteration is compiled as one function: a step takes less time than
// passing its vectors through memory would.
//
// Source: rows as in constraints.h; the derivations stand above next() and differentiate().
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"
#include "core/mechanism/two_part_angle.h"

#include <cmath>

namespace slidercrank
{

class StructuredSystem
{
public:
    using Coordinates = NamedCoordinates;
    static Coordinates read(const Vector12 &q) { return namedCoordinates(q); }
    static void write(const Coordinates &q, Vector12 &to) { setCoordinates(to, q); }

    StructuredSystem(const Mechanism &mechanism, double t)
        : m_isCrossed(mechanism.branch() == Branch::Crossed)
        , m_halfA(0.5 * mechanism.a())
        , m_halfB(0.5 * mechanism.b())
        , m_c(mechanism.c())
        , m_omega2(mechanism.omega2())
        , m_drive(mechanism.omega2() * t + mechanism.theta20())
        , m_drivenCrank{std::sin(m_drive), std::cos(m_drive)}
    {
    }

    /// Evaluates C at q.
    void moveTo(const Coordinates &q)
    {
        m_exactTheta3 = q.theta3;
        m_isRotated = false;
        const double sine = std::sin(q.theta3);
        const double cosine = std::cos(q.theta3);
        m_coupler = {sine, cosine};
        fillRows(q);
    }

    // moveNear() rotates sine and cosine of θ3 by a small angle δ:
    //
    //     sin (θ + δ) = sin θ + (cos θ sin δ - sin θ (1 - cos δ)),
    //     cos (θ + δ) = cos θ - (sin θ sin δ + cos θ (1 - cos δ)),
    //
    // where the terms in brackets are so small that only the sums round.

    /// Evaluates C at a q that is probably the last iterate. If θ3 is close to that of the last moveTo(), |cos θ3| is
    /// at least 0.125 there, and moveNear() has not been called since, the sine and cosine of θ3 are obtained by a
    /// rotation, which is faster than computing them and adds one rounding. Otherwise equals moveTo().
    void moveNear(const Coordinates &q)
    {
        constexpr double kSmallTurn = 0x1p-11; // rad; δ⁵/120, the first neglected term, is then below 3e-19
        // The derivatives contain 1/cos³ θ3: below this |cos θ3| they need every digit of the cosine.
        constexpr double kMinCosine = 0.125;
        const double turn = q.theta3 - m_exactTheta3;
        if (m_isRotated || !(std::abs(turn) <= kSmallTurn) || std::abs(m_coupler.cos) < kMinCosine) { // also for NaN
            moveTo(q);
            return;
        }
        m_isRotated = true;
        const double square = turn * turn;
        const double turnSine = turn - turn * square * (1.0 / 6.0);
        const double turnVersine = square * (0.5 - square * (1.0 / 24.0));
        const double sine = m_coupler.sin + (m_coupler.cos * turnSine - m_coupler.sin * turnVersine);
        const double cosine = m_coupler.cos - (m_coupler.sin * turnSine + m_coupler.cos * turnVersine);
        m_coupler = {sine, cosine};
        fillRows(q);
    }

    /// Returns ‖C‖ with the length rows multiplied by `perLength`.
    double residual(double perLength) const
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

    // C_q x = r, with (a/2) u(θ2) = (Ax, Ay) and (b/2) u(θ3) = (Bx, By). Eight rows give one unknown each as soon as
    // those before it are known:
    //
    //     θ1 = r3      R1 = (r1, r2)      θ4 = r10 + θ1      θ2 = r12      R4y = r11
    //     R2x = r4 - Ay θ2                R2y = r5 + Ax θ2
    //
    // θ3 and R3y remain in rows 7 and 9:
    //
    //     7:   R2y + Ax θ2 - R3y + Bx θ3 = r7
    //     9:   R4y - R3y - Bx θ3 = r9
    //
    // Their difference does not contain R3y, and has the only pivot that is not 1 (det C_q is its negative). Their sum
    // does not contain θ3, nor the digits that θ3 loses where Bx is small:
    //
    //     2 Bx θ3 = (r7 - R2y - Ax θ2) - (r9 - R4y)
    //     2 R3y   = (R2y + Ax θ2) + R4y - (r7 + r9)
    //
    // The remaining rows follow in turn:
    //
    //     6:   R3x = R2x - Ay θ2 - By θ3 - r6
    //     8:   R4x = R3x - By θ3 + r8

    /// Returns q + Δq with C_q Δq = -C, for the q of the last moveTo() or moveNear(). Not finite where cos θ3 = 0.
    Coordinates next(const Coordinates &q)
    {
        if (m_isRotated) {
            moveTo(q); // so that the step equals that of the dense elimination except for rounding
        }
        // The locals hold -Δq, the solution for r = C.
        const Rows &r = m_C;
        const double pinX = m_crankY * r.crankDrive;
        const double pinY = m_crankX * r.crankDrive;
        const double R2x = r.crankPivotX - pinX;
        const double R2y = r.crankPivotY + pinY;
        const double theta3 = theta3Excess();
        const double R3y = 0.5 * ((R2y + pinY) + r.sliderLine - (r.crankPinY + r.sliderPinY));
        const double couplerX = m_couplerY * theta3;
        const double R3x = R2x - pinX - couplerX - r.crankPinX;
        const double R4x = R3x - couplerX + r.sliderPinX;
        return {.R1x = q.R1x - r.groundX,
                .R1y = q.R1y - r.groundY,
                .theta1 = q.theta1 - r.groundAngle,
                .R2x = q.R2x - R2x,
                .R2y = q.R2y - R2y,
                .theta2 = q.theta2 - r.crankDrive,
                .R3x = q.R3x - R3x,
                .R3y = q.R3y - R3y,
                .theta3 = q.theta3 - theta3,
                .R4x = q.R4x - R4x,
                .R4y = q.R4y - r.sliderLine,
                .theta4 = q.theta4 - (r.sliderAngle + r.groundAngle)};
    }

    double cosTheta3() const { return m_coupler.cos; }

    // The only row of -C_t that is not 0 is the drive's, r12 = ω. So q̇ = ω q', where the elimination above gives, for a
    // drive of 1,
    //
    //     R2' = (-Ay, Ax)     Bx θ3' = -Ax     R3y' = Ax     R3x' = -2 Ay - By θ3'     R4x' = -2 Ay - 2 By θ3'
    //
    // In Q_d rows 4 to 9 are not 0: each ±(r) u(θ) of C becomes ±(r) θ̇² u(θ). So q̈ = ω² q'', where, with w = By θ3',
    // and Bx θ3'² = -Ax θ3' by the line above, the right-hand sides
    //
    //     r4, r5 = -Ax, -Ay     r6 = Ax - Ax θ3'     r7 = Ay + w θ3'     r8 = Ax θ3'     r9 = -w θ3'
    //
    // give, with θ2'' = 0,
    //
    //     R2'' = (-Ax, -Ay)     Bx θ3'' = Ay + w θ3'     R3y'' = -Ay
    //     R3x'' = Ax (θ3' - 2) - By θ3''     R4x'' = 2 (Ax (θ3' - 1) - By θ3'')
    //
    // On the crossed branch θ3 is near π, where neighbouring doubles are four times as far apart as near 0.5: (Bx, By)
    // is rotated by the part of θ3 that was rounded off, as far as C shows it.

    /// Solves C_q q̇ = -C_t and C_q q̈ = Q_d at the current q, and stores q̇ and q̈ in `state`. Returns whether they are
    /// finite.
    bool differentiate(State &state) const
    {
        const double Ax = m_crankX;
        const double Ay = m_crankY;
        double Bx = m_couplerX;
        double By = m_couplerY;
        if (m_isCrossed) {
            constexpr double kRounded = 1e-15; // rad; a larger excess is not rounding, but due to the tolerance
            const double measured = theta3Excess();
            const double excess = std::abs(measured) <= kRounded ? measured : 0.0;
            Bx = m_couplerX + m_couplerY * excess;
            By = m_couplerY - m_couplerX * excess;
        }
        const double v = m_omega2;
        const double vSquared = v * v;

        const double theta3Prime = -Ax / Bx;
        const double w = By * theta3Prime;
        setCoordinates(state.qDot, {.R2x = -Ay * v,
                                    .R2y = Ax * v,
                                    .theta2 = v,
                                    .R3x = (-2.0 * Ay - w) * v,
                                    .R3y = Ax * v,
                                    .theta3 = theta3Prime * v,
                                    .R4x = -2.0 * (Ay + w) * v});

        const double theta3DoublePrime = (Ay + w * theta3Prime) * (1.0 / Bx);
        const double couplerTerm = By * theta3DoublePrime;
        const double theta3DDot = theta3DoublePrime * vSquared;
        const double R3xDDot = (Ax * (theta3Prime - 2.0) - couplerTerm) * vSquared;
        const double R4xDDot = 2.0 * (Ax * (theta3Prime - 1.0) - couplerTerm) * vSquared;
        setCoordinates(state.qDDot, {.R2x = -Ax * vSquared,
                                     .R2y = -Ay * vSquared,
                                     .R3x = R3xDDot,
                                     .R3y = -Ay * vSquared,
                                     .theta3 = theta3DDot,
                                     .R4x = R4xDDot});

        // No other value is larger than the largest of these.
        return std::isfinite(theta3DDot) && std::isfinite(R3xDDot) && std::isfinite(R4xDDot);
    }

private:
    struct Rows {
        double groundX, groundY, groundAngle, crankPivotX, crankPivotY, crankPinX, crankPinY, sliderPinX, sliderPinY,
            sliderAngle, sliderLine, crankDrive;
    };

    /// Computes the rows of C. The row of the drive is linear, so that θ2 is exact from the second iterate on.
    void fillRows(const Coordinates &q)
    {
        const bool isDriven = q.theta2 == m_drive;
        m_crankX = m_halfA * (isDriven ? m_drivenCrank.cos : std::cos(q.theta2));
        m_crankY = m_halfA * (isDriven ? m_drivenCrank.sin : std::sin(q.theta2));
        m_couplerX = m_halfB * m_coupler.cos;
        m_couplerY = m_halfB * m_coupler.sin;
        m_C = {.groundX = q.R1x,
               .groundY = q.R1y,
               .groundAngle = q.theta1,
               .crankPivotX = q.R2x - m_crankX,
               .crankPivotY = q.R2y - m_crankY,
               .crankPinX = -q.R3x + q.R2x + m_crankX + m_couplerX,
               .crankPinY = -q.R3y + q.R2y + m_crankY + m_couplerY,
               .sliderPinX = q.R4x - q.R3x - m_couplerX,
               .sliderPinY = q.R4y - q.R3y - m_couplerY,
               .sliderAngle = q.theta4 - q.theta1,
               .sliderLine = q.R4y - m_c,
               .crankDrive = q.theta2 - m_drive};
    }

    /// Returns -Δθ3 of the Newton step.
    double theta3Excess() const
    {
        const double pinY = m_crankX * m_C.crankDrive;
        const double R2y = m_C.crankPivotY + pinY;
        return ((m_C.crankPinY - R2y - pinY) - (m_C.sliderPinY - m_C.sliderLine)) * (0.5 / m_couplerX);
    }

    bool m_isCrossed;
    double m_halfA;
    double m_halfB;
    double m_c;
    double m_omega2;
    double m_drive;                ///< ω2 t + θ20
    SinCos m_drivenCrank;          ///< sine and cosine of m_drive
    SinCos m_coupler;              ///< sine and cosine of θ3
    double m_exactTheta3 = kNone;  ///< θ3 of the last moveTo()
    bool m_isRotated = false;      ///< the last move was a rotation in moveNear()
    double m_crankX, m_crankY;     ///< (a/2) u(θ2)
    double m_couplerX, m_couplerY; ///< (b/2) u(θ3)
    Rows m_C;
};

} // namespace slidercrank
