// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/two_part_angle.h"

#include <cmath>

namespace slidercrank
{

namespace
{

#if !defined(__FMA__) && !defined(__aarch64__)
/// The upper 26 and the lower 27 bits of x (Veltkamp).
TwoPart split(double x)
{
    constexpr double kSplitter = 134217729.0; // 2^27 + 1
    const double scaled = kSplitter * x;
    const double upper = scaled - (scaled - x);
    return {upper, x - upper};
}
#endif

} // namespace

TwoPart twoProduct(double x, double y)
{
    const double product = x * y;
#if defined(__FMA__) || defined(__aarch64__)
    return {product, __builtin_fma(x, y, -product)}; // the instruction; a library's fma need not be exact
#else
    const TwoPart xs = split(x);
    const TwoPart ys = split(y);
    return {product, ((xs.hi * ys.hi - product) + xs.hi * ys.lo + xs.lo * ys.hi) + xs.lo * ys.lo};
#endif
}

TwoPart crankAngle(double omega2, double t, double theta20)
{
    const TwoPart turned = twoProduct(omega2, t);
    const TwoPart sum = twoSum(turned.hi, theta20);
    return twoSum(sum.hi, sum.lo + turned.lo);
}

SinCos sinCos(TwoPart angle)
{
    const double s = std::sin(angle.hi);
    const double c = std::cos(angle.hi);
    double sinLo = angle.lo;
    double versineLo = 0.5 * angle.lo * angle.lo; // 1 - cos
    constexpr double kSecondOrder = 5e-6;         // rad: below this the next term, lo³/6, is under half an ulp of 1
    if (std::abs(angle.lo) > kSecondOrder) {
        const double sinHalf = std::sin(0.5 * angle.lo);
        sinLo = std::sin(angle.lo);
        versineLo = 2.0 * sinHalf * sinHalf;
    }
    return {s + (c * sinLo - s * versineLo), c - (s * sinLo + c * versineLo)};
}

} // namespace slidercrank
