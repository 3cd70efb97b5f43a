// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the closed form of one mechanism needs at every instant, worked out once. Names as in clearance.h and
// closed_form.h; lengths in units of the clearance's scale.

#include "core/closed_form/clearance.h"
#include "core/mechanism/mechanism.h"

namespace slidercrank
{

struct MotionConstants {
    // The crank's angle is taken as g θ2, whose sine is x.
    double sideOmega = 0.0;      ///< g ω
    double sideOmegaUpper = 0.0; ///< its upper 26 bits,
    double sideOmegaLower = 0.0; ///< ... and the others, for a product without error
    double sideTheta20 = 0.0;    ///< g θ20
    double latest = 0.0;         ///< until |t| is that, |θ2| is at most 1.6e6 rad, and so are its parts; < 0: never

    double scale = 1.0; ///< mm
    double a = 0.0;
    double b = 0.0;
    double C = 0.0;
    double epsilon = 0.0;
    double beta = 0.0;
    double nearLimit = 0.0;     ///< where p or m is less, the kernel leaves an instant to the clearance
    double side = 1.0;          ///< g
    double branch = 1.0;        ///< +1 open, -1 crossed
    double straightAngle = 0.0; ///< what ±atan2(g h, |s|) is added to: 0 open, π crossed

    double epsilonReach = 0.0;  ///< ε L
    double aC = 0.0;            ///< a C
    double aOmega = 0.0;        ///< a ω
    double aOmegaSquared = 0.0; ///< a ω²
    double bSquared = 0.0;
    double aBSquared = 0.0; ///< a b²
};

MotionConstants motionConstants(const Mechanism &mechanism);

} // namespace slidercrank
