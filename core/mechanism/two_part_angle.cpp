// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism/two_part_angle.h"

#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

// The following functions compute with about 106 bits.

TwoPart sum(TwoPart x, double y)
{
    const TwoPart total = twoSum(x.hi, y);
    return twoSum(total.hi, total.lo + x.lo);
}

TwoPart product(TwoPart x, TwoPart y)
{
    const TwoPart total = twoProduct(x.hi, y.hi);
    return twoSum(total.hi, total.lo + (x.hi * y.lo + x.lo * y.hi));
}

TwoPart quotient(TwoPart x, double divisor)
{
    const double first = x.hi / divisor;
    const TwoPart back = twoProduct(first, divisor);
    return twoSum(first, ((x.hi - back.hi) - back.lo + x.lo) / divisor);
}

/// Returns 1 - z/(k (k+1)) (1 - z/((k+2) (k+3)) (1 - ...)) for 0 <= z <= (π/4)², k = 2 or 3. The terms after the
/// first eight are below half a unit in the last place of 1, so that a single double suffices for them.
TwoPart sineOrCosineSeries(TwoPart z, int k)
{
    constexpr int kTwoPartTerms = 8;
    constexpr int kTerms = 14;
    const auto divisor = [k](int term) { return static_cast<double>((k + 2 * term) * (k + 2 * term + 1)); };
    double tail = 1.0;
    for (int term = kTerms - 1; term >= kTwoPartTerms; --term) {
        tail = 1.0 - z.hi * tail / divisor(term);
    }
    TwoPart series{tail, 0.0};
    for (int term = kTwoPartTerms - 1; term >= 0; --term) {
        series = sum(quotient(product(z, series), -divisor(term)), 1.0);
    }
    return series;
}

} // namespace

TwoPart twoProduct(double x, double y)
{
    const double product = x * y;
#if defined(__FMA__) || defined(__aarch64__)
    return {product, __builtin_fma(x, y, -product)}; // the machine instruction; fma() of a library need not be exact
#else
    const TwoPart xs = split(x);
    const TwoPart ys = split(y);
    return {product, ((xs.hi * ys.hi - product) + xs.hi * ys.lo + xs.lo * ys.hi) + xs.lo * ys.lo};
#endif
}

TwoPart crankAngle(double omega2, double t, double theta20)
{
    return sum(twoProduct(omega2, t), theta20);
}

SinCos sinCos(TwoPart angle)
{
    const double s = std::sin(angle.hi);
    const double c = std::cos(angle.hi);
    double sinLo = angle.lo;
    double versineLo = 0.5 * angle.lo * angle.lo; // 1 - cos
    constexpr double kLargestSecondOrder = 5e-6;  // rad: up to it, the next term, lo³/6, is below half an ulp of 1
    if (std::abs(angle.lo) > kLargestSecondOrder) {
        sinLo = std::sin(angle.lo);
        const double sinHalfLo = std::sin(0.5 * angle.lo);
        versineLo = 2.0 * sinHalfLo * sinHalfLo;
    }
    return {s + (c * sinLo - s * versineLo), c - (s * sinLo + c * versineLo)};
}

FineSine fineSine(TwoPart angle)
{
    // r = hi + lo - n π/2 with π/2 = P1 + P2 + P3. The difference of hi and the upper part of n P1 is exact.
    const double n = std::round(angle.hi * (2.0 / std::numbers::pi));
    const TwoPart first = twoProduct(n, 0x1.921fb54442d18p+0);
    const TwoPart second = twoProduct(n, 0x1.1a62633145c07p-54);
    TwoPart r = twoSum(angle.hi - first.hi, -first.lo);
    r = sum(r, angle.lo);
    r = sum(r, -second.hi);
    r = sum(r, -second.lo - n * -0x1.f1976b7ed8fbcp-110);

    const TwoPart z = product(r, r);
    const int quadrant = static_cast<int>(n - 4.0 * std::floor(0.25 * n));
    const double sign = quadrant < 2 ? 1.0 : -1.0;
    if (quadrant % 2 == 0) {
        const TwoPart sine = product(r, sineOrCosineSeries(z, 2));
        return {0.0, {sign * sine.hi, sign * sine.lo}};
    }
    const TwoPart versine = product({0.5 * z.hi, 0.5 * z.lo}, sineOrCosineSeries(z, 3));
    return {sign, {-sign * versine.hi, -sign * versine.lo}};
}

} // namespace slidercrank
