// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clearance.h"

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
    m_reach = exactSum(m_a, m_b, m_offset);
}

Clearance::At Clearance::at(SinCos crank) const
{
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
    return at;
}

} // namespace slidercrank
