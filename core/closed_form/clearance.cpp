// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/clearance.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// x + y + z with a single rounding, but for ties.
double exactSum(double x, double y, double z)
{
    const TwoPart first = twoSum(x, y);
    const TwoPart second = twoSum(first.hi, z);
    return second.hi + (second.lo + first.lo);
}

} // namespace

Clearance::Clearance(const Mechanism &mechanism)
    : m_side(mechanism.c() < 0.0 ? -1.0 : 1.0)
{
    const double a = mechanism.a();
    const double b = mechanism.b();
    const double offset = std::abs(mechanism.c());
    const int exponent = std::ilogb(a + b + offset);
    m_scale = std::ldexp(1.0, exponent);
    m_a = std::ldexp(a, -exponent);
    m_b = std::ldexp(b, -exponent);
    m_offset = std::ldexp(offset, -exponent);
    m_epsilon = exactSum(m_b, -m_a, -m_offset);
    m_beta = exactSum(m_b, m_offset, -m_a);
    m_gamma = exactSum(m_a, m_b, -m_offset);
    m_reach = exactSum(m_a, m_b, m_offset);
    constexpr double kNear = 0x1p-10; // of the reach: beyond, a difference of doubles keeps all but three digits
    m_nearLimit = m_epsilon < 0.0 ? kNear * m_reach : 0.0;
}

/// p for +1, m for -1: b - g h and its mirror image (x → -x, C → -C), rounded once.
double Clearance::fineGap(double sideOfGap, TwoPart theta2) const
{
    const double turn = sideOfGap * m_side;
    const FineSine x = fineSine({turn * theta2.hi, turn * theta2.lo});
    const TwoPart lengths = twoSum(m_b, -sideOfGap * m_offset);
    const TwoPart whole = twoSum(lengths.hi, m_a * x.whole);
    const TwoPart part = twoProduct(m_a, x.part.hi);
    const TwoPart gap = twoSum(whole.hi, part.hi);
    const double difference = gap.hi + (gap.lo + ((whole.lo + lengths.lo) + (part.lo + m_a * x.part.lo)));

    // What is 0 to 30 digits is the limit itself: a mechanism that is locked keeps its one pose, whose angle is no
    // double.
    constexpr double kLastDigits = 0x1p-100;
    return std::abs(difference) < kLastDigits * m_reach ? 0.0 : difference;
}

Clearance::At Clearance::at(TwoPart theta2) const
{
    const SinCos crank = sinCos(theta2);
    At at;
    at.x = m_side * crank.sin;
    at.cosine = crank.cos;
    const double cosineSquared = crank.cos * crank.cos;
    if (at.x < 0.0) {
        at.sigma = cosineSquared / (1.0 - at.x);
        at.sigmaMirrored = 1.0 - at.x;
    } else {
        at.sigma = 1.0 + at.x;
        at.sigmaMirrored = cosineSquared / (1.0 + at.x);
    }
    at.p = m_epsilon + m_a * at.sigma;
    at.m = m_beta + m_a * at.sigmaMirrored;
    at.h = m_offset - m_a * at.x;
    if (std::abs(std::min(at.p, at.m)) < m_nearLimit && std::abs(theta2.hi) <= kLargestFineAngle) {
        if (at.p <= at.m) {
            at.p = fineGap(1.0, theta2);
            at.m = 2.0 * m_b - at.p;
            at.h = m_b - at.p;
        } else {
            at.m = fineGap(-1.0, theta2);
            at.p = 2.0 * m_b - at.m;
            at.h = at.m - m_b;
        }
    }
    return at;
}

} // namespace slidercrank
