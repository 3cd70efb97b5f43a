// SPDX-License-Identifier: GPL-3.0-or-later

// The closed form of closed_form.h for as many instants as a vector has lanes: for one in closed_form.cpp, for more,
// once for each instruction set, in batch.cpp. Every lane goes through the same roundings in the same order on every
// instruction set: products are never fused with sums unless the result is exact either way. Compile with
// -ffp-contract=off, lest the compiler fuse them.
//
// Sources: W. J. Cody, W. Waite, "Software Manual for the Elementary Functions", 1980 (reduction by a π/2 in parts);
//          T. J. Dekker, "A floating-point technique for extending the available precision", 1971 (TwoProduct);
//          polynomials of least relative error (Remez), computed for this file in 60 digits.

#if defined(SLIDERCRANK_MOTION_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SLIDERCRANK_MOTION_KERNEL_INL_H
#undef SLIDERCRANK_MOTION_KERNEL_INL_H
#else
#define SLIDERCRANK_MOTION_KERNEL_INL_H
#endif

#include "core/closed_form/motion_constants.h"

#include <hwy/highway.h>

#include <cmath>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace slidercrank
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

// Highway's single lane takes signs through integer registers, on the longest chain there is; the standard functions do
// not.
#if HWY_TARGET == HWY_SCALAR
template <class V>
HWY_INLINE V magnitude(V x)
{
    return V(std::fabs(x.raw));
}
template <class V>
HWY_INLINE V withSignOf(V size, V sign)
{
    return V(std::copysign(size.raw, sign.raw));
}
#else
template <class V>
HWY_INLINE V magnitude(V x)
{
    return hn::Abs(x);
}
template <class V>
HWY_INLINE V withSignOf(V size, V sign)
{
    return hn::CopySignToAbs(size, sign);
}
#endif

/// sum + error = x + y exactly.
template <class V>
HWY_INLINE void exactSum(V x, V y, V &sum, V &error)
{
    sum = hn::Add(x, y);
    const V yRounded = hn::Sub(sum, x);
    const V xRounded = hn::Sub(sum, yRounded);
    error = hn::Add(hn::Sub(x, xRounded), hn::Sub(y, yRounded));
}

/// The same where x is the larger of the two, or their sum is exact.
template <class V>
HWY_INLINE void exactSumOrdered(V x, V y, V &sum, V &error)
{
    sum = hn::Add(x, y);
    error = hn::Sub(y, hn::Sub(sum, x));
}

/// product + error = g ω t exactly.
template <class D, class V>
HWY_INLINE void exactTurn(D d, const MotionConstants &k, V t, V &product, V &error)
{
    const V omega = hn::Set(d, k.sideOmega);
    product = hn::Mul(omega, t);
#if HWY_NATIVE_FMA
    error = hn::MulSub(omega, t, product);
#else
    const V upper = hn::Set(d, k.sideOmegaUpper);
    const V lower = hn::Set(d, k.sideOmegaLower);
    const V scaled = hn::Mul(hn::Set(d, kSplitter), t);
    const V tUpper = hn::Sub(scaled, hn::Sub(scaled, t));
    const V tLower = hn::Sub(t, tUpper);
    const V left = hn::Add(hn::Sub(hn::Mul(upper, tUpper), product), hn::Mul(upper, tLower));
    error = hn::Add(hn::Add(left, hn::Mul(lower, tUpper)), hn::Mul(lower, tLower));
#endif
}

/// Sine and cosine of hi + lo (rad), for |hi| <= 1.6e6 and |lo| <= 1e-9; beyond, anything.
template <class D, class V>
HWY_INLINE void sineAndCosine(D d, V hi, V lo, V &sine, V &cosine)
{
    // r = rHi + rLo = hi + lo - n π/2, |r| <= π/4 and a little, with π/2 = P1 + P2 + P3. P1 and P2 have 33 bits and n
    // has 20, so that n P1, n P2 and hi - n P1 are exact, and the next difference is where it is not ordered.
    const hn::RebindToUnsigned<D> du;
    const V shifter = hn::Set(d, 6755399441055744.0); // 1.5 · 2^52: the sum's last bits are the rounded integer
    const V shifted = hn::Add(hn::Mul(hi, hn::Set(d, 0x1.45f306dc9c883p-1)), shifter);
    const V n = hn::Sub(shifted, shifter);
    const V first = hn::Sub(hi, hn::Mul(n, hn::Set(d, 0x1.921fb54400000p+0)));
    V second, secondError;
    exactSumOrdered(first, hn::Mul(n, hn::Set(d, -0x1.0b4611a600000p-34)), second, secondError);
    const V third = hn::Add(hn::Add(secondError, lo), hn::Mul(n, hn::Set(d, -0x1.3198a2e037073p-69)));
    V rHi, rLo;
    exactSumOrdered(second, third, rHi, rLo);

    const V z = hn::Mul(rHi, rHi);
    const V zz = hn::Mul(z, z);

    // sin r = r + r z S(z)
    const V s01 = hn::Add(hn::Set(d, -0.16666666666666632), hn::Mul(z, hn::Set(d, 0.00833333333332242)));
    const V s23 = hn::Add(hn::Set(d, -0.00019841269829812546), hn::Mul(z, hn::Set(d, 2.7557313693621505e-06)));
    const V s45 = hn::Add(hn::Set(d, -2.505075839093975e-08), hn::Mul(z, hn::Set(d, 1.589681212937157e-10)));
    const V S = hn::Add(s01, hn::Mul(zz, hn::Add(s23, hn::Mul(zz, s45))));
    const V sineR = hn::Add(rHi, hn::Add(rLo, hn::Mul(hn::Mul(rHi, z), S)));

    // cos r = 1 - (z/2 - z² Q(z))
    const V c01 = hn::Add(hn::Set(d, 0.0416666666666666), hn::Mul(z, hn::Set(d, -0.0013888888888874131)));
    const V c23 = hn::Add(hn::Set(d, 2.4801587289487236e-05), hn::Mul(z, hn::Set(d, -2.755731435384784e-07)));
    const V c45 = hn::Add(hn::Set(d, 2.087572348632916e-09), hn::Mul(z, hn::Set(d, -1.1359659190841573e-11)));
    const V Q = hn::Add(c01, hn::Mul(zz, hn::Add(c23, hn::Mul(zz, c45))));
    const V beyond = hn::Sub(hn::Mul(zz, Q), hn::Mul(rHi, rLo));
    const V cosineR = hn::Sub(hn::Set(d, 1.0), hn::Sub(hn::Mul(z, hn::Set(d, 0.5)), beyond));

    // The quadrant n mod 4: odd exchanges the two, bit 1 of n turns the sine's sign, bit 1 of n + 1 the cosine's.
#if HWY_TARGET == HWY_SCALAR
    constexpr double kSineSign[] = {1.0, 1.0, -1.0, -1.0};
    constexpr double kCosineSign[] = {1.0, -1.0, -1.0, 1.0};
    const auto quadrant = hn::GetLane(hn::BitCast(du, shifted)) % 4;
    const bool odd = quadrant % 2 != 0;
    sine = hn::Mul(odd ? cosineR : sineR, hn::Set(d, kSineSign[quadrant]));
    cosine = hn::Mul(odd ? sineR : cosineR, hn::Set(d, kCosineSign[quadrant]));
#else
    const auto quadrant = hn::BitCast(du, shifted);
    const auto unit = hn::Set(du, std::uint64_t{1});
    const auto odd = hn::RebindMask(d, hn::TestBit(quadrant, unit));
    const auto signBit = hn::Set(du, std::uint64_t{1} << 63);
    const auto sineSign = hn::And(hn::ShiftLeft<62>(quadrant), signBit);
    const auto cosineSign = hn::And(hn::ShiftLeft<62>(hn::Add(quadrant, unit)), signBit);
    sine = hn::Xor(hn::IfThenElse(odd, cosineR, sineR), hn::BitCast(d, sineSign));
    cosine = hn::Xor(hn::IfThenElse(odd, sineR, cosineR), hn::BitCast(d, cosineSign));
#endif
}

/// atan2(y, x) for x >= 0, not both zero.
template <class D, class V>
HWY_INLINE V halfPlaneAngle(D d, V y, V x)
{
    // With v = lesser/greater the angle from the nearer axis is atan v, and π/4 + atan((v - 1)/(v + 1)) where v exceeds
    // tan(π/8): one quotient of magnitude at most 0.4143.
    const V height = magnitude(y);
    const V lesser = hn::Min(height, x);
    const V greater = hn::Max(height, x);
    const auto steep = hn::Gt(height, x);
    const auto diagonal = hn::Gt(lesser, hn::Mul(greater, hn::Set(d, 0.41421356237309503)));
    const V numerator = hn::Sub(lesser, hn::IfThenElseZero(diagonal, greater));
    const V denominator = hn::Add(greater, hn::IfThenElseZero(diagonal, lesser));
    const V v = hn::Div(numerator, denominator);

    // atan v = v + v w A(w), w = v²
    const V w = hn::Mul(v, v);
    const V ww = hn::Mul(w, w);
    const V w4 = hn::Mul(ww, ww);
    const V a01 = hn::Add(hn::Set(d, -0.333333333333332), hn::Mul(w, hn::Set(d, 0.19999999999954043)));
    const V a23 = hn::Add(hn::Set(d, -0.14285714280244285), hn::Mul(w, hn::Set(d, 0.11111110785915787)));
    const V a45 = hn::Add(hn::Set(d, -0.09090897829776445), hn::Mul(w, hn::Set(d, 0.07692061513745321)));
    const V a67 = hn::Add(hn::Set(d, -0.06663118932786156), hn::Mul(w, hn::Set(d, 0.05847998031302008)));
    const V a89 = hn::Add(hn::Set(d, -0.05039795105499212), hn::Mul(w, hn::Set(d, 0.03807700814192793)));
    const V a03 = hn::Add(a01, hn::Mul(ww, a23));
    const V a47 = hn::Add(a45, hn::Mul(ww, a67));
    const V a8A = hn::Add(a89, hn::Mul(ww, hn::Set(d, -0.01792080866245795)));
    const V A = hn::Add(a03, hn::Mul(w4, hn::Add(a47, hn::Mul(w4, a8A))));
    const V arc = hn::Add(v, hn::Mul(hn::Mul(v, w), A));

    // 0 + arc, π/4 + arc, π/4 - arc or π/2 - arc; a double π is short of π by 3.9e-17 of itself.
    const V flatBase = hn::IfThenElseZero(diagonal, hn::Set(d, 0x1.921fb54442d18p-1));
    const V base = hn::IfThenElse(steep, hn::Sub(hn::Set(d, 0x1.921fb54442d18p+0), flatBase), flatBase);
    const V baseLo = hn::Mul(base, hn::Set(d, 3.8981718325193755e-17));
    const V signedArc = hn::IfThenElse(steep, hn::Neg(arc), arc);
    return withSignOf(hn::Add(base, hn::Add(baseLo, signedArc)), y);
}

/// g θ2 = hi + lo, its sine x and its cosine, which is that of θ2, at the instants t. x is NaN where the angle may be
/// too large for the reduction, or t is no number.
template <class D, class V>
HWY_INLINE void turnCrank(D d, const MotionConstants &k, V t, V &hi, V &lo, V &x, V &cos2)
{
    V turned, turnedLo, sumError;
    exactTurn(d, k, t, turned, turnedLo);
    exactSum(turned, hn::Set(d, k.sideTheta20), hi, sumError);
    lo = hn::Add(sumError, turnedLo);
    sineAndCosine(d, hi, lo, x, cos2);
    x = hn::IfThenElse(hn::Le(magnitude(t), hn::Set(d, k.latest)), x, hn::NaN(d));
}

/// θ3, from h and |s|.
template <class D, class V>
HWY_INLINE V couplerAngle(D d, const MotionConstants &k, V h, V root)
{
    return hn::Add(hn::Set(d, k.straightAngle), hn::Mul(hn::Set(d, k.branch * k.side), halfPlaneAngle(d, h, root)));
}

/// h and |s| for couplerAngle(), and what else `out` wants, stored there: s, R4x, velocities (θ̇3, ṡ, Ṙ4x) and
/// accelerations, in mm and rad. False, and nothing stored, when a lane may be anything but Solved, is
/// near a limit of a rocker, or its x is NaN.
template <class D, class V, class Out>
HWY_INLINE bool moveLinks(D d, const MotionConstants &k, V x, V cos2, const Out &out, V &h, V &root)
{
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0);

    // clearance.h
    const V a = hn::Set(d, k.a);
    const V cosineSquared = hn::Mul(cos2, cos2);
    const V sumOfLike = hn::Add(one, magnitude(x));
    const V differenceOfLike = hn::Div(cosineSquared, sumOfLike);
    const auto below = hn::Lt(x, zero);
    const V sigma = hn::IfThenElse(below, differenceOfLike, sumOfLike);
    const V sigmaMirrored = hn::IfThenElse(below, sumOfLike, differenceOfLike);
    const V p = hn::Add(hn::Set(d, k.epsilon), hn::Mul(a, sigma));
    const V m = hn::Add(hn::Set(d, k.beta), hn::Mul(a, sigmaMirrored));
    h = hn::Sub(hn::Set(d, k.C), hn::Mul(a, x));
    const V sSquared = hn::Mul(p, m);
    root = hn::Sqrt(sSquared);

    // Above this no derivative overflows: the speed is at most 1e12 and lengths are below 4.
    const auto regular = hn::Ge(root, hn::Set(d, 1e-60));
    if (!hn::AllTrue(d, hn::And(regular, hn::Ge(hn::Min(p, m), hn::Set(d, k.nearLimit))))) {
        return false;
    }

    const V branch = hn::Set(d, k.branch);
    const V scale = hn::Set(d, k.scale);
    const V s = hn::Mul(branch, root);
    out.storeS(d, hn::Mul(scale, s));
    if (out.wantsR4x()) {
        const V aCos = hn::Mul(a, cos2);
        V R4x = hn::Add(aCos, s);
        const auto opposed = hn::Lt(hn::Mul(cos2, s), zero);
        if (!hn::AllFalse(d, opposed)) {
            const V numerator = hn::Add(hn::Set(d, k.epsilonReach), hn::Mul(hn::Set(d, 2.0 * k.aC), sigma));
            R4x = hn::IfThenElse(opposed, hn::Div(numerator, hn::Sub(s, aCos)), R4x);
        }
        out.storeR4x(d, hn::Mul(scale, R4x));
    }
    if (!out.wantsVelocity() && !out.wantsAcceleration()) {
        return true;
    }

    const V inverse = hn::Div(branch, root);
    if (out.wantsVelocity()) {
        const V theta3Dot = hn::Mul(hn::Mul(hn::Set(d, -k.aOmega), cos2), inverse);
        const V sDot = hn::Mul(hn::Mul(hn::Set(d, -k.side), h), theta3Dot);
        const V R4xDot = hn::Sub(sDot, hn::Mul(hn::Set(d, k.side * k.aOmega), x));
        out.storeVelocity(d, theta3Dot, hn::Mul(scale, sDot), hn::Mul(scale, R4xDot));
    }
    if (out.wantsAcceleration()) {
        const V inverseCubed = hn::Mul(hn::Mul(inverse, inverse), inverse);
        const V epsilonReach = hn::Set(d, k.epsilonReach);
        const V turn = hn::Add(hn::Mul(hn::Set(d, k.aC), hn::Mul(sigma, sigma)), hn::Mul(x, epsilonReach));
        const V theta3DDot = hn::Mul(hn::Mul(hn::Set(d, k.side * k.aOmegaSquared), turn), inverseCubed);

        // G, in the form for this steepness; see accelerationNumerator() in closed_form.cpp.
        const V aBSquared = hn::Set(d, k.aBSquared);
        const V bSquared = hn::Set(d, k.bSquared);
        const auto flat = hn::Ge(sSquared, hn::Mul(hn::Set(d, 0.75), bSquared));
        V G = zero;
        if (!hn::AllFalse(d, flat)) {
            G = hn::Add(hn::Mul(aBSquared, cosineSquared), hn::Mul(hn::Mul(h, x), sSquared));
        }
        if (!hn::AllTrue(d, flat)) {
            const auto up = hn::Ge(h, zero);
            const V like = hn::IfThenElse(up, sigma, sigmaMirrored);
            const V gap = hn::IfThenElse(up, p, m);
            const V spare = hn::IfThenElse(up, hn::Set(d, k.epsilon), hn::Set(d, k.beta));
            const V xMirrored = hn::IfThenElse(up, hn::Neg(x), x);
            const V gapTerm = hn::Mul(hn::Mul(gap, gap), hn::Sub(hn::Set(d, 3.0 * k.b), gap));
            const V spareTerm = hn::Mul(hn::Set(d, 2.0 * k.bSquared), spare);
            const V steep =
                hn::Add(hn::Mul(aBSquared, hn::Mul(like, like)), hn::Mul(xMirrored, hn::Sub(gapTerm, spareTerm)));
            G = hn::IfThenElse(flat, G, steep);
        }
        const V sDDot = hn::Mul(hn::Mul(hn::Set(d, -k.aOmegaSquared), G), inverseCubed);
        const V R4xDDot = hn::Sub(sDDot, hn::Mul(hn::Set(d, k.aOmegaSquared), cos2));
        out.storeAcceleration(d, theta3DDot, hn::Mul(scale, sDDot), hn::Mul(scale, R4xDDot));
    }
    return true;
}

} // namespace HWY_NAMESPACE
} // namespace slidercrank
HWY_AFTER_NAMESPACE();

#endif
