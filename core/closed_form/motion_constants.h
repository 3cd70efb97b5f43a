// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The constants of one mechanism that the closed form needs at every time stamp. Lengths in mm, angles in rad.
//
// With h = c - a sin θ2, the height of B above A, the coupler has sin θ3 = h/b. The motion is ill-conditioned where
// b - |h| is small. Subtracting a rounded h from b loses its digits; the following sums do not:
//
//     C = |c|,  g = sign of c,  x = g sin θ2,  ε = b - a - C,  β = b + C - a,  γ = a + b - C,  L = a + b + C
//     p = b - g h = ε + a (1 + x)        m = b + g h = β + a (1 - x)               b cos θ3 = ±√(p m)
//
// If ε >= 0 (the crank makes full turns), all terms of p and m are non-negative, so that nothing cancels. If ε < 0 (a
// rocker), p or m cancels near a limit position, where it is computed from a sine with about 30 digits.

#include "core/mechanism/mechanism.h"

namespace slidercrank
{

struct MotionConstants {
    explicit MotionConstants(const Mechanism &mechanism);

    double a;
    double b;
    double C;    ///< |c|
    double side; ///< g: +1 for c >= 0, -1 for c < 0

    // Sums of the lengths, each of which is rounded only once.
    double epsilon; ///< ε, negative for a rocker
    double beta;    ///< β, negative for a rocker with two arcs
    double gamma;   ///< γ, negative if the mechanism cannot be assembled
    double reach;   ///< L

    /// If p or m is less than this, a sine in double precision has too few digits; 0 if ε >= 0.
    double nearLimit;

    double branch;        ///< +1 open, -1 crossed
    double straightAngle; ///< θ3 of a coupler along the slider's line: 0 open, π crossed

    // Products.
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
    double latest; ///< s: for |t| below it, crankAngleWithSine() computes the crank angle and its sine exactly enough
};

} // namespace slidercrank
