// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion_constants.h"

#include <numbers>

namespace slidercrank
{

MotionConstants motionConstants(const Mechanism &mechanism)
{
    const Clearance lengths(mechanism);
    const bool open = mechanism.branch() == Branch::Open;
    constexpr double kSplitter = 134217729.0; // 2^27 + 1
    const double scaled = kSplitter * mechanism.omega2();

    MotionConstants k;
    k.omega = mechanism.omega2();
    k.omegaUpper = scaled - (scaled - k.omega);
    k.omegaLower = k.omega - k.omegaUpper;
    k.theta20 = mechanism.theta20();
    k.scale = lengths.scale();
    k.a = lengths.a();
    k.b = lengths.b();
    k.C = lengths.offset();
    k.epsilon = lengths.epsilon();
    k.beta = lengths.beta();
    k.side = lengths.side();
    k.branch = open ? 1.0 : -1.0;
    k.straightAngle = open ? 0.0 : std::numbers::pi;
    k.epsilonReach = k.epsilon * lengths.reach();
    k.aC = k.a * k.C;
    k.aOmega = k.a * k.omega;
    k.aOmegaSquared = k.aOmega * k.omega;
    k.bSquared = k.b * k.b;
    k.aBSquared = k.a * k.bSquared;
    return k;
}

} // namespace slidercrank
