// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/closed_form.h"

#include "core/closed_form/motion_kernel-inl.h"

#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

namespace hn = hwy::HWY_NAMESPACE;

double cube(double x)
{
    return x * x * x;
}

/// a C σ² + x ε L of θ̈3. For a rocker the two may cancel where x > 0; there it is taken from x p m + a h cos²θ2, or,
/// where that cancels too, from the first one's mirror image.
double turnNumerator(const Clearance &lengths, const Clearance::At &at)
{
    const double a = lengths.a();
    const double C = lengths.offset();
    if (lengths.epsilon() < 0.0 && at.x > 0.0) {
        const double first = at.x * at.p * at.m;
        const double second = a * at.h * at.cosine * at.cosine;
        if (at.h >= 0.0 || first < -0.5 * second) {
            return first + second;
        }
        return a * C * at.sigmaMirrored * at.sigmaMirrored + at.x * lengths.beta() * lengths.gamma();
    }
    return a * C * at.sigma * at.sigma + at.x * lengths.epsilon() * lengths.reach();
}

/// G of s̈ = -a ω² G / s³, that is a b² cos²θ2 + h x s², which cancels where the coupler is steep. There, with h = b - p
/// and p = ε + aσ, the terms that cancel are
///     a b² (1 - x²) + 2 b² x p = a b² σ² + 2 b² x ε,
/// and the mirror image of that (x → -x, p → m, ε → β, σ → σ') where h < 0.
double accelerationNumerator(const Clearance &lengths, const Clearance::At &at)
{
    const double a = lengths.a();
    const double bSquared = lengths.b() * lengths.b();
    const double sSquared = at.p * at.m;
    const bool likeTerms = lengths.epsilon() < 0.0 && at.x >= 0.0 && at.h >= 0.0;
    if (likeTerms || sSquared >= 0.75 * bSquared) {
        return a * bSquared * at.cosine * at.cosine + at.h * at.x * sSquared;
    }
    if (at.h >= 0.0) {
        return a * bSquared * at.sigma * at.sigma -
               at.x * (at.p * at.p * (3.0 * lengths.b() - at.p) - 2.0 * bSquared * lengths.epsilon());
    }
    return a * bSquared * at.sigmaMirrored * at.sigmaMirrored +
           at.x * (at.m * at.m * (3.0 * lengths.b() - at.m) - 2.0 * bSquared * lengths.beta());
}

/// a cos θ2 + s; where the two would cancel, (s² - a² cos²θ2) / (s - a cos θ2) with the numerator rearranged,
///     ε L + 2 a C σ   or its mirror image   β γ - 2 a C σ'.
/// While ε >= 0 the first cannot cancel. For a rocker either can, beyond what it is to save.
double sliderPosition(const Clearance &lengths, const Clearance::At &at, double s)
{
    const double aCos = lengths.a() * at.cosine;
    if (at.cosine * s >= 0.0) {
        return aCos + s;
    }
    const double difference = s - aCos;
    const double twice = 2.0 * lengths.a() * lengths.offset();
    if (lengths.epsilon() >= 0.0) {
        return (lengths.epsilon() * lengths.reach() + twice * at.sigma) / difference;
    }
    const bool mirrored = at.x > 0.0;
    const double constant = mirrored ? lengths.beta() * lengths.gamma() : lengths.epsilon() * lengths.reach();
    if (std::abs(constant) > difference * difference) {
        return aCos + s;
    }
    return (constant + (mirrored ? -twice * at.sigmaMirrored : twice * at.sigma)) / difference;
}

/// Puts the one lane of a vector into a Motion.
struct MotionStore {
    Motion *motion;

    static constexpr bool wantsR4x() { return true; }
    static constexpr bool wantsVelocity() { return true; }
    static constexpr bool wantsAcceleration() { return true; }

    template <class D, class V>
    void storeS(D d, V s) const
    {
        hn::StoreU(s, d, &motion->s);
    }
    template <class D, class V>
    void storeR4x(D d, V R4x) const
    {
        hn::StoreU(R4x, d, &motion->R4x);
    }
    template <class D, class V>
    void storeVelocity(D d, V theta3Dot, V sDot, V R4xDot) const
    {
        hn::StoreU(theta3Dot, d, &motion->theta3Dot);
        hn::StoreU(sDot, d, &motion->sDot);
        hn::StoreU(R4xDot, d, &motion->R4xDot);
    }
    template <class D, class V>
    void storeAcceleration(D d, V theta3DDot, V sDDot, V R4xDDot) const
    {
        hn::StoreU(theta3DDot, d, &motion->theta3DDot);
        hn::StoreU(sDDot, d, &motion->sDDot);
        hn::StoreU(R4xDDot, d, &motion->R4xDDot);
    }
};

} // namespace

ClosedForm::ClosedForm(const Mechanism &mechanism)
    : m_mechanism(mechanism)
    , m_clearance(mechanism)
    , m_constants(motionConstants(mechanism))
{
}

Motion ClosedForm::motionAt(double t) const
{
    namespace kernel = HWY_NAMESPACE;
    const hn::CappedTag<double, 1> d;
    using V = hn::Vec<decltype(d)>;
    V hi, lo, x, cos2, h, root;
    kernel::turnCrank(d, m_constants, hn::Set(d, t), hi, lo, x, cos2);
    Motion motion;
    if (!kernel::moveLinks(d, m_constants, x, cos2, MotionStore{&motion}, h, root)) {
        return motionStepByStep(t);
    }
    motion.theta2 = m_constants.side * hn::GetLane(hn::Add(hi, lo));
    motion.crank = {m_constants.side * hn::GetLane(x), hn::GetLane(cos2)};
    motion.theta3 = hn::GetLane(kernel::couplerAngle(d, m_constants, h, root));
    motion.status = Status::Solved;
    return motion;
}

Motion ClosedForm::motionStepByStep(double t) const
{
    const TwoPart angle = crankAngle(m_mechanism.omega2(), t, m_mechanism.theta20());
    Motion motion{angle.hi, {kNone, kNone}, kNone, kNone, kNone, kNone,
                  kNone,    kNone,          kNone, kNone, kNone, Status::Solved};
    if (!std::isfinite(angle.hi) || !std::isfinite(angle.lo)) {
        motion.status = Status::NotFinite;
        return motion;
    }
    const Clearance::At at = m_clearance.at(angle);
    motion.crank = {m_clearance.side() * at.x, at.cosine};
    if (!at.assemblable()) {
        motion.status = Status::NotAssemblable;
        return motion;
    }

    // Lengths in units of the scale, as the clearance has them.
    const double a = m_clearance.a();
    const double scale = m_clearance.scale();
    const double omega = m_mechanism.omega2();
    const double side = m_clearance.side();
    const bool open = m_mechanism.branch() == Branch::Open;
    const double sin2 = motion.crank.sin;
    const double cos2 = motion.crank.cos;

    const double root = std::sqrt(at.p * at.m);
    const double s = open ? root : -root;
    const double steepness = std::atan2(side * at.h, root);
    motion.theta3 = open ? steepness : std::numbers::pi - steepness;
    motion.s = scale * s;
    motion.R4x = scale * sliderPosition(m_clearance, at, s);

    const double sCubed = cube(s);
    const double theta3Dot = -a * omega * cos2 / s;
    const double theta3DDot = side * a * omega * omega * turnNumerator(m_clearance, at) / sCubed;
    const double sDot = -side * at.h * theta3Dot;
    const double sDDot = -a * omega * omega * accelerationNumerator(m_clearance, at) / sCubed;
    if (!std::isfinite(theta3Dot) || !std::isfinite(theta3DDot) || !std::isfinite(sDDot)) {
        motion.status = Status::Singular;
        return motion;
    }
    motion.theta3Dot = theta3Dot;
    motion.theta3DDot = theta3DDot;
    motion.sDot = scale * sDot;
    motion.sDDot = scale * sDDot;
    motion.R4xDot = scale * (-a * omega * sin2 + sDot);
    motion.R4xDDot = scale * (-a * omega * omega * cos2 + sDDot);
    return motion;
}

} // namespace slidercrank
