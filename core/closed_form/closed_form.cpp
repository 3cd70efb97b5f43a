// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/closed_form.h"

#include "core/closed_form/motion_kernel-inl.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

namespace kernel = HWY_NAMESPACE;
using Clearance = kernel::Clearance<double>;

/// Sets all members of `motion` except θ2 and the status. `root`: √(p m).
HWY_INLINE void setLinks(const MotionConstants &k, const Clearance &at, double root, Motion &motion)
{
    const double s = k.branch * root;
    const double inverse = k.branch / root;
    const kernel::Rates<double> first = kernel::velocities(k, at, inverse);
    const kernel::Rates<double> second = kernel::accelerations(k, at, inverse);
    motion.crank = {k.side * at.x, at.cosine};
    motion.s = s;
    motion.sDot = first.s;
    motion.sDDot = second.s;
    motion.theta3 = kernel::couplerAngle(k, at.h, root);
    motion.theta3Dot = first.theta3;
    motion.theta3DDot = second.theta3;
    motion.R4x = kernel::sliderPosition(k, at, s);
    motion.R4xDot = first.R4x;
    motion.R4xDDot = second.R4x;
}

/// Returns p = b - g h for gapSide = 1, or its mirror image m = b + g h for gapSide = -1, with a single rounding.
double fineGap(const MotionConstants &k, double gapSide, TwoPart theta2)
{
    const double sign = gapSide * k.side;
    const FineSine x = fineSine({sign * theta2.hi, sign * theta2.lo});
    const TwoPart lengths = twoSum(k.b, -gapSide * k.C);
    const TwoPart whole = twoSum(lengths.hi, k.a * x.whole);
    const TwoPart part = twoProduct(k.a, x.part.hi);
    const TwoPart gap = twoSum(whole.hi, part.hi);
    const double difference = gap.hi + (gap.lo + ((whole.lo + lengths.lo) + (part.lo + k.a * x.part.lo)));

    // A difference that is 0 to 30 digits is the limit itself. It need not be exactly 0: no double equals the only
    // crank angle of a locked mechanism.
    constexpr double kLastDigits = 0x1p-100;
    return std::abs(difference) < kLastDigits * k.reach ? 0.0 : difference;
}

/// Returns p, m and h at a crank angle. Near a limit position of a rocker, they are computed from a sine with about 30
/// digits.
Clearance clearanceAt(const MotionConstants &k, TwoPart theta2)
{
    const SinCos crank = sinCos(theta2);
    Clearance at = kernel::clearance(k, k.side * crank.sin, crank.cos);
    if (std::abs(std::min(at.p, at.m)) < k.nearLimit && std::abs(theta2.hi) <= kLargestFineAngle) {
        if (at.p <= at.m) {
            at.p = fineGap(k, 1.0, theta2);
            at.m = 2.0 * k.b - at.p;
            at.h = k.b - at.p;
        } else {
            at.m = fineGap(k, -1.0, theta2);
            at.p = 2.0 * k.b - at.m;
            at.h = at.m - k.b;
        }
    }
    return at;
}

} // namespace

ClosedForm::ClosedForm(const Mechanism &mechanism)
    : m_mechanism(mechanism)
    , m_constants(mechanism)
{
}

Motion ClosedForm::motionAt(double t) const
{
    double hi, lo, x, cosine;
    kernel::crankAngleWithSine(m_constants, t, hi, lo, x, cosine);
    const Clearance at = kernel::clearance(m_constants, x, cosine);
    const double root = std::sqrt(at.p * at.m);
    if (!kernel::isOrdinary(m_constants, at, root)) {
        return difficultMotionAt(t);
    }
    Motion motion;
    motion.theta2 = m_constants.side * (hi + lo);
    setLinks(m_constants, at, root, motion);
    return motion;
}

Motion ClosedForm::difficultMotionAt(double t) const
{
    const TwoPart angle = crankAngle(m_mechanism.omega2(), t, m_mechanism.theta20());
    Motion motion;
    motion.theta2 = angle.hi;
    if (!std::isfinite(angle.hi) || !std::isfinite(angle.lo)) {
        motion.status = Status::NotFinite;
        return motion;
    }
    const Clearance at = clearanceAt(m_constants, angle);
    if (at.p < 0.0 || at.m < 0.0) {
        motion.status = Status::NotAssemblable;
        motion.crank = {m_constants.side * at.x, at.cosine};
        return motion;
    }
    setLinks(m_constants, at, std::sqrt(at.p * at.m), motion);
    if (motion.s == 0.0) {
        motion.status = Status::Singular;
        motion.sDot = motion.theta3Dot = motion.R4xDot = kNone;
        motion.sDDot = motion.theta3DDot = motion.R4xDDot = kNone;
    }
    return motion;
}

} // namespace slidercrank
