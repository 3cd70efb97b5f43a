// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the closed form of one mechanism needs at every time stamp, computed once. Lengths in mm, angles in rad.
//
// With h = c - a sin θ2, the height of B above A, the coupler has sin θ3 = h/b. Every difficulty of the slider-crank
// arises where b - |h| is tiny. Subtracting a rounded h from b loses its digits; these sums keep them:
//
//     C = |c|,  g = sign of c,  x = g sin θ2,  ε = b - a - C,  β = b + C - a,  γ = a + b - C,  L = a + b + C
//     p = b - g h = ε + a (1 + x)        m = b + g h = β + a (1 - x)               b cos θ3 = ±√(p m)
//
// While ε >= 0 (the crank turns all round) every term of p and m is non-negative, so nothing cancels. While ε < 0 (a
// rocker) one of them cancels near a limit of the motion; there it is computed from a sine with some 30 digits.

#include "core/mechanism/mechanism.h"

namespace slidercrank
{

struct MotionConstants {
    explicit MotionConstants(const Mechanism &mechanism);

    double a;
    double b;
    double C;    ///< |c|
    double side; ///< g: +1 for c >= 0, -1 for c < 0

    // Each is rounded only once.
    double epsilon; ///< ε, negative for a rocker
    double beta;    ///< β, negative for a rocker with two arcs
    double gamma;   ///< γ, negative where there is no pose
    double reach;   ///< L

    /// Where p or m is less than this, a double sine has too few digits; 0 while ε >= 0.
    double nearLimit;

    double branch;        ///< +1 open, -1 crossed
    double straightAngle; ///< θ3 of a coupler along the slider's line: 0 open, π crossed

    // Products of the above.
    double epsilonReach; ///< ε L
    double betaGamma;    ///< β γ
    double aC;
    double bSquared;
    double aBSquared;
    double aOmega;        ///< a ω
    double aOmegaSquared; ///< a ω²

    // The crank angle is computed as g θ2, whose sine is x.
    double sideOmega;   ///< g ω
    double sideTheta20; ///< g θ20
    double latest;      ///< s: below this |t| the crank angle is small enough to be reduced in vectors
};

} // namespace slidercrank
