// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/motion_constants.h"

#include "core/mechanism/two_part_angle.h"

#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

/// Returns x + y + z with a single rounding, except for ties.
double exactSum(double x, double y, double z)
{
    const TwoPart first = twoSum(x, y);
    const TwoPart second = twoSum(first.hi, z);
    return second.hi + (second.lo + first.lo);
}

} // namespace

MotionConstants::MotionConstants(const Mechanism &mechanism)
    : a(mechanism.a())
    , b(mechanism.b())
    , C(std::abs(mechanism.c()))
    , side(mechanism.c() < 0.0 ? -1.0 : 1.0)
    , epsilon(exactSum(b, -a, -C))
    , beta(exactSum(b, C, -a))
    , gamma(exactSum(a, b, -C))
    , reach(exactSum(a, b, C))
{
    // If p or m is at least this fraction of the reach, a difference of doubles loses three digits at most.
    constexpr double kNearFraction = 0x1p-10;
    nearLimit = epsilon < 0.0 ? kNearFraction * reach : 0.0;

    const bool isOpen = mechanism.branch() == Branch::Open;
    branch = isOpen ? 1.0 : -1.0;
    straightAngle = isOpen ? 0.0 : std::numbers::pi;

    const double omega = mechanism.omega2();
    epsilonReach = epsilon * reach;
    betaGamma = beta * gamma;
    aC = a * C;
    bSquared = b * b;
    aBSquared = a * bSquared;
    aOmega = a * omega;
    aOmegaSquared = aOmega * omega;

    constexpr double kLargestAngle = 1.6e6; // rad: up to it, sineAndCosine() subtracts quarter turns exactly
    constexpr double kLatest = 1e290;       // s: split() would overflow beyond it
    const double angleLeft = kLargestAngle - std::abs(mechanism.theta20());
    sideOmega = side * omega;
    sideTheta20 = side * mechanism.theta20();
    latest = angleLeft < std::abs(omega) * kLatest ? angleLeft / std::abs(omega) : kLatest;
}

} // namespace slidercrank
