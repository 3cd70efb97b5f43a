// SPDX-License-Identifier: GPL-3.0-or-later

// The formulas of closed_form.h as templates of the number type: double for one time stamp (closed_form.cpp), or Lanes,
// a vector of doubles (batch.cpp, compiled once for each instruction set). All instruction sets perform the same
// roundings in the same order: a product is fused with a sum only if the result is exact in either case. Compile with
// -ffp-contract=off, so that the compiler does not fuse them.
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
#include "core/closed_form/vector_targets.h"
#include "core/mechanism/two_part_angle.h"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace slidercrank
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// The largest number of time stamps in a block, whose vectors are evaluated together.
inline constexpr std::size_t kMaxBlock = 64;

/// The largest number of time stamps in a vector.
inline constexpr std::size_t kMaxLanes = 8;

/// A vector of doubles with the operators of a number.
struct Lanes {
    using Tag = hn::CappedTag<double, kMaxLanes>;
    using Vector = hn::Vec<Tag>;
    using Mask = hn::Mask<Tag>;

    Vector v;

    HWY_INLINE Lanes(Vector vector)
        : v(vector)
    {
    }
    HWY_INLINE Lanes(double number)
        : v(hn::Set(Tag(), number))
    {
    }
    static HWY_INLINE Lanes load(const double *from) { return hn::LoadU(Tag(), from); }
    HWY_INLINE void store(double *to) const { hn::StoreU(v, Tag(), to); }

    friend HWY_INLINE Lanes operator+(Lanes x, Lanes y) { return hn::Add(x.v, y.v); }
    friend HWY_INLINE Lanes operator-(Lanes x, Lanes y) { return hn::Sub(x.v, y.v); }
    friend HWY_INLINE Lanes operator*(Lanes x, Lanes y) { return hn::Mul(x.v, y.v); }
    friend HWY_INLINE Lanes operator/(Lanes x, Lanes y) { return hn::Div(x.v, y.v); }
    friend HWY_INLINE Mask operator<(Lanes x, Lanes y) { return hn::Lt(x.v, y.v); }
};

HWY_INLINE Lanes abs(Lanes x)
{
    return hn::Abs(x.v);
}
HWY_INLINE Lanes copysign(Lanes magnitude, Lanes sign)
{
    return hn::CopySignToAbs(magnitude.v, sign.v);
}
HWY_INLINE Lanes sqrt(Lanes x)
{
    return hn::Sqrt(x.v);
}
HWY_INLINE Lanes select(Lanes::Mask condition, Lanes yes, Lanes no)
{
    return hn::IfThenElse(condition, yes.v, no.v);
}
HWY_INLINE Lanes::Mask both(Lanes::Mask first, Lanes::Mask second)
{
    return hn::And(first, second);
}
HWY_INLINE bool none(Lanes::Mask condition)
{
    return hn::AllFalse(Lanes::Tag(), condition);
}

using std::abs;
using std::copysign;
HWY_INLINE double select(bool condition, double yes, double no)
{
    return condition ? yes : no;
}
HWY_INLINE bool both(bool first, bool second)
{
    return first && second;
}
HWY_INLINE bool none(bool condition)
{
    return !condition;
}

/// Sine and cosine of r + n π/2, from those of r. `shifted` has n in its last bits: odd n exchanges the two, bit 1 of n
/// changes the sine's sign and bit 1 of n + 1 the cosine's.
HWY_INLINE void rotateByQuarters(Lanes shifted, Lanes &sine, Lanes &cosine)
{
    const Lanes::Tag d;
    const hn::RebindToUnsigned<Lanes::Tag> du;
    const auto quarters = hn::BitCast(du, shifted.v);
    const auto one = hn::Set(du, std::uint64_t{1});
    const auto signBit = hn::Set(du, std::uint64_t{1} << 63);
    const Lanes::Mask odd = hn::RebindMask(d, hn::TestBit(quarters, one));
    const Lanes newSine = select(odd, cosine, sine);
    const Lanes newCosine = select(odd, sine, cosine);
    sine = hn::Xor(newSine.v, hn::BitCast(d, hn::And(hn::ShiftLeft<62>(quarters), signBit)));
    cosine = hn::Xor(newCosine.v, hn::BitCast(d, hn::And(hn::ShiftLeft<62>(hn::Add(quarters, one)), signBit)));
}
HWY_INLINE void rotateByQuarters(double shifted, double &sine, double &cosine)
{
    constexpr double kSineSign[] = {1.0, 1.0, -1.0, -1.0};
    constexpr double kCosineSign[] = {1.0, -1.0, -1.0, 1.0};
    const auto quarters = std::bit_cast<std::uint64_t>(shifted) % 4;
    const double newSine = quarters % 2 != 0 ? cosine : sine;
    cosine = (quarters % 2 != 0 ? sine : cosine) * kCosineSign[quarters];
    sine = newSine * kSineSign[quarters];
}

/// Sine and cosine of hi + lo (rad), for |hi| <= 1.6e6 and |lo| <= 1e-9; meaningless beyond.
template <class Number>
HWY_INLINE void sineAndCosine(Number hi, Number lo, Number &sine, Number &cosine)
{
    // r = rHi + rLo = hi + lo - n π/2, where |r| exceeds π/4 only slightly, with π/2 = P1 + P2 + P3. P1 and P2 have 33
    // bits and n has 20, so that n P1, n P2 and first = hi - n P1 are exact. `third` contains the rounding error of
    // `second`. That error is exact if |first| >= |n P2|; if |first| is smaller, `second` itself is exact.
    constexpr double kShifter = 0x1.8p52; // the sum's last bits are the rounded integer
    const Number shifted = hi * 0x1.45f306dc9c883p-1 + kShifter;
    const Number n = shifted - kShifter;
    const Number first = hi - n * 0x1.921fb54400000p+0;
    const Number smallPart = n * -0x1.0b4611a600000p-34;
    const Number second = first + smallPart;
    const Number third = (smallPart - (second - first)) + lo + n * -0x1.3198a2e037073p-69;
    const Number rHi = second + third;
    const Number rLo = third - (rHi - second);
    const Number z = rHi * rHi;
    const Number zz = z * z;

    // sin r = r + r z S(z)
    const Number s01 = -0.16666666666666632 + z * 0.00833333333332242;
    const Number s23 = -0.00019841269829812546 + z * 2.7557313693621505e-06;
    const Number s45 = -2.505075839093975e-08 + z * 1.589681212937157e-10;
    const Number S = s01 + zz * (s23 + zz * s45);
    sine = rHi + (rLo + rHi * z * S);

    // cos r = 1 - (z/2 - z² Q(z))
    const Number c01 = 0.0416666666666666 + z * -0.0013888888888874131;
    const Number c23 = 2.4801587289487236e-05 + z * -2.755731435384784e-07;
    const Number c45 = 2.087572348632916e-09 + z * -1.1359659190841573e-11;
    const Number Q = c01 + zz * (c23 + zz * c45);
    cosine = 1.0 - (z * 0.5 - (zz * Q - rHi * rLo));

    rotateByQuarters(shifted, sine, cosine);
}

/// atan2(y, x) for x >= 0, not both zero.
template <class Number>
HWY_INLINE Number halfPlaneAngle(Number y, Number x)
{
    // With v = lesser/greater the angle from the nearer axis is atan v, and π/4 + atan((v - 1)/(v + 1)) where v exceeds
    // tan(π/8): one quotient of magnitude at most 0.4143.
    const Number height = abs(y);
    const auto steep = x < height;
    const Number lesser = select(steep, x, height);
    const Number greater = select(steep, height, x);
    const auto diagonal = greater * 0.41421356237309503 < lesser;
    const Number v = select(diagonal, lesser - greater, lesser) / select(diagonal, greater + lesser, greater);

    // atan v = v + v w A(w), w = v²
    const Number w = v * v;
    const Number ww = w * w;
    const Number w4 = ww * ww;
    const Number a01 = -0.333333333333332 + w * 0.19999999999954043;
    const Number a23 = -0.14285714280244285 + w * 0.11111110785915787;
    const Number a45 = -0.09090897829776445 + w * 0.07692061513745321;
    const Number a67 = -0.06663118932786156 + w * 0.05847998031302008;
    const Number a89 = -0.05039795105499212 + w * 0.03807700814192793;
    const Number a8A = a89 + ww * -0.01792080866245795;
    const Number A = a01 + ww * a23 + w4 * (a45 + ww * a67 + w4 * a8A);
    const Number arc = v + v * w * A;

    // 0 + arc, π/4 + arc, π/4 - arc or π/2 - arc; a double π is short of π by 3.9e-17 of itself.
    const Number flatBase = select(diagonal, 0x1.921fb54442d18p-1, 0.0);
    const Number base = select(steep, 0x1.921fb54442d18p+0 - flatBase, flatBase);
    const Number signedArc = select(steep, 0.0 - arc, arc);
    return copysign(base + (base * 3.8981718325193755e-17 + signedArc), y);
}

/// Returns the crank angle at time t (s) in its last four arguments: g θ2 = hi + lo, its sine x, and its cosine, which
/// is that of θ2. x is NaN if t is not a number or if the angle may be too large for the argument reduction.
template <class Number>
HWY_INLINE void crankAngleWithSine(const MotionConstants &k, Number t, Number &hi, Number &lo, Number &x,
                                   Number &cosine)
{
    // turned + turnedLo = g ω t exactly (Dekker), hi + sumError = turned + g θ20 exactly (Knuth).
    const TwoPart omega = split(k.sideOmega);
    const Number turned = k.sideOmega * t;
    const Number scaled = kSplitter * t;
    const Number tUpper = scaled - (scaled - t);
    const Number tLower = t - tUpper;
    const Number turnedLo = ((omega.hi * tUpper - turned) + omega.hi * tLower + omega.lo * tUpper) + omega.lo * tLower;
    hi = turned + k.sideTheta20;
    const Number second = hi - turned;
    const Number sumError = (turned - (hi - second)) + (k.sideTheta20 - second);
    lo = sumError + turnedLo;
    sineAndCosine(hi, lo, x, cosine);
    x = select(abs(t) < k.latest, x, kNone);
}

/// The quantities that determine the position of the coupler, with x, p, m, g and h as in motion_constants.h.
template <class Number>
struct Clearance {
    Number x, cosine;            ///< x = g sin θ2, and cos θ2
    Number sigma, sigmaMirrored; ///< σ = 1 + x and σ' = 1 - x, without cancellation
    Number p, m;
    Number h; ///< g h
};

template <class Number>
HWY_INLINE Clearance<Number> clearance(const MotionConstants &k, Number x, Number cosine)
{
    const Number larger = 1.0 + abs(x);
    const Number smaller = cosine * cosine / larger;
    const auto below = x < 0.0;
    const Number sigma = select(below, smaller, larger);
    const Number sigmaMirrored = select(below, larger, smaller);
    return {.x = x,
            .cosine = cosine,
            .sigma = sigma,
            .sigmaMirrored = sigmaMirrored,
            .p = k.epsilon + k.a * sigma,
            .m = k.beta + k.a * sigmaMirrored,
            .h = k.C - k.a * x};
}

/// Returns whether the formulas are accurate and the status is Solved; false if x is NaN. `root`: √(p m).
template <class Number>
HWY_INLINE auto isOrdinary(const MotionConstants &k, const Clearance<Number> &at, Number root)
{
    const Number limit = k.nearLimit;
    return both(Number(0.0) < root, both(limit < at.p, limit < at.m));
}

/// Returns θ3, computed from g h and |s|.
template <class Number>
HWY_INLINE Number couplerAngle(const MotionConstants &k, Number h, Number root)
{
    return k.straightAngle + k.branch * k.side * halfPlaneAngle(h, root);
}

/// Returns R4x. If a cos θ2 and s have opposite signs and the crank makes full turns, it is (s² - a² cos²θ2) / (s - a
/// cos θ2) with the numerator rearranged: ε L + 2 a C σ.
template <class Number>
HWY_INLINE Number sliderPosition(const MotionConstants &k, const Clearance<Number> &at, Number s)
{
    const Number aCos = k.a * at.cosine;
    const auto opposed = at.cosine * s < 0.0;
    if (k.epsilon < 0.0 || none(opposed)) {
        return aCos + s;
    }
    return select(opposed, (k.epsilonReach + 2.0 * k.aC * at.sigma) / (s - aCos), aCos + s);
}

/// First or second derivatives of θ3, s and R4x.
template <class Number>
struct Rates {
    Number theta3, s, R4x;
};

/// Returns the velocities. `inverse`: 1/s, where s = b cos θ3.
template <class Number>
HWY_INLINE Rates<Number> velocities(const MotionConstants &k, const Clearance<Number> &at, Number inverse)
{
    const Number theta3Dot = -k.aOmega * at.cosine * inverse;
    const Number sDot = -k.side * at.h * theta3Dot;
    return {theta3Dot, sDot, sDot - k.side * k.aOmega * at.x};
}

/// Returns G of s̈ = -a ω² G / s³. Its two terms cancel where the coupler is steep and h and x have opposite signs.
/// There, with h = b - p and p = ε + aσ, the part that cancels is
///     a b² (1 - x²) + 2 b² x p = a b² σ² + 2 b² x ε,
/// and the mirror image of that (x → -x, p → m, ε → β, σ → σ') where h < 0.
template <class Number>
HWY_INLINE Number sDDotNumerator(const MotionConstants &k, const Clearance<Number> &at)
{
    const Number sSquared = at.p * at.m;
    const Number hx = at.h * at.x;
    const Number direct = k.aBSquared * (at.cosine * at.cosine) + hx * sSquared;
    const auto steep = both(hx < 0.0, sSquared < 0.75 * k.bSquared);
    if (none(steep)) {
        return direct;
    }
    const auto down = at.h < 0.0;
    const Number sigma = select(down, at.sigmaMirrored, at.sigma);
    const Number gap = select(down, at.m, at.p);
    const Number lengthSum = select(down, k.beta, k.epsilon);
    const Number gapTerm = gap * gap * (3.0 * k.b - gap);
    const Number rearranged = k.aBSquared * (sigma * sigma) + abs(at.x) * (gapTerm - 2.0 * k.bSquared * lengthSum);
    return select(steep, rearranged, direct);
}

/// Returns N of θ̈3 = g a ω² N / s³. Rearranged, nothing cancels near a toggle: a C δ² + x K, with δ = min(σ, σ') =
/// cos²θ2/(1 + |x|) and K = ε L for x < 0, β γ for x >= 0. For a rocker the rearranged sum is better only where the
/// original one cancels.
template <class Number>
HWY_INLINE Number theta3DDotNumerator(const MotionConstants &k, const Clearance<Number> &at)
{
    const auto below = at.x < 0.0;
    const Number delta = select(below, at.sigma, at.sigmaMirrored);
    const Number rearranged = k.aC * (delta * delta) + at.x * select(below, k.epsilonReach, k.betaGamma);
    if (k.epsilon >= 0.0) {
        return rearranged;
    }
    const Number first = at.x * (at.p * at.m);
    const Number second = k.a * at.h * (at.cosine * at.cosine);
    const auto termsCancel = both(at.h * at.x < 0.0, abs(second) < 2.0 * abs(first));
    return select(termsCancel, rearranged, first + second);
}

/// Returns the accelerations. `inverse`: 1/s, where s = b cos θ3.
template <class Number>
HWY_INLINE Rates<Number> accelerations(const MotionConstants &k, const Clearance<Number> &at, Number inverse)
{
    const Number inverseCubed = inverse * inverse * inverse;
    const Number theta3DDot = k.side * k.aOmegaSquared * theta3DDotNumerator(k, at) * inverseCubed;
    const Number sDDot = -k.aOmegaSquared * sDDotNumerator(k, at) * inverseCubed;
    return {theta3DDot, sDDot, sDDot - k.aOmegaSquared * at.cosine};
}

} // namespace HWY_NAMESPACE
} // namespace slidercrank
HWY_AFTER_NAMESPACE();

#endif
