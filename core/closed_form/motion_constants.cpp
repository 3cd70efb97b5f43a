// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/motion_constants.h"

#include <cmath>
#include <numbers>

namespace slidercrank
{

MotionConstants motionConstants(const Mechanism &mechanism)
{
    const Clearance lengths(mechanism);
    const bool open = mechanism.branch() == Branch::Open;
    constexpr double kLargestAngle = 1.6e6; // rad: what the kernel can reduce
    constexpr double kLatest = 1e290;       // s: what can be split
    const double omega = mechanism.omega2();
    const TwoPart sideOmega = split(lengths.side() * omega);
    const double angleLeft = kLargestAngle - std::abs(mechanism.theta20());

    MotionConstants k;
    k.sideOmega = lengths.side() * omega;
    k.sideOmegaUpper = sideOmega.hi;
    k.sideOmegaLower = sideOmega.lo;
    k.sideTheta20 = lengths.side() * mechanism.theta20();
    k.latest = angleLeft < std::abs(omega) * kLatest ? angleLeft / std::abs(omega) : kLatest;
    k.scale = lengths.scale();
    k.a = lengths.a();
    k.b = lengths.b();
    k.C = lengths.offset();
    k.epsilon = lengths.epsilon();
    k.beta = lengths.beta();
    k.nearLimit = lengths.nearLimit();
    k.side = lengths.side();
    k.branch = open ? 1.0 : -1.0;
    k.straightAngle = open ? 0.0 : std::numbers::pi;
    k.epsilonReach = k.epsilon * lengths.reach();
    k.aC = k.a * k.C;
    k.aOmega = k.a * omega;
    k.aOmegaSquared = k.aOmega * omega;
    k.bSquared = k.b * k.b;
    k.aBSquared = k.a * k.bSquared;
    return k;
}

} // namespace slidercrank
