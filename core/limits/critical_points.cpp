// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/critical_points.h"

#include "core/closed_form/closed_form.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slidercrank
{

namespace
{

constexpr double kBesideToggle = 1e-15; // rad
constexpr std::size_t kCount = kPlottedChannels.size();

/// The channels at one crank angle for ω2 = 1, and their derivatives with respect to the angle.
struct Rates {
    std::array<double, kCount> value;
    std::array<double, kCount> slope;
};

/// The motion near a crank angle of ±90°, at which the coupler is steepest, as a function of u. If the mechanism passes
/// this angle, the crank is at φ = w sinh u from it: with w = √(2·gap/a), where b cos θ3 ∝ √(gap + a φ²/2), every
/// feature of the motion has a width of about one unit of u, however small the gap is. If it does not pass the angle,
/// it approaches it to φ₀, with cos φ₀ = 1 + gap/a, and φ = ±φ₀ cosh u has the same effect.
class SteepPlace
{
public:
    /// `gap`: the excess of the coupler length over the length required to pass the angle, in units of `a`.
    SteepPlace(const Mechanism &mechanism, double centre, double gap)
        : m_a(mechanism.a())
        , m_c(mechanism.c())
        , m_centre(centre)
        , m_gap(gap)
        , m_width(gap > 0.0   ? std::min(1.0, std::sqrt(2.0 * gap))
                  : gap < 0.0 ? 2.0 * std::asin(std::sqrt(-0.5 * gap))
                              : 1.0)
        , m_motion(withDrive(mechanism, 1.0, centre))
    {
    }

    /// Returns the smallest |φ| that the motion reaches.
    double nearest() const { return m_gap < 0.0 ? m_width : 0.0; }

    bool isPassed() const { return m_gap > 0.0; }
    bool isToggle() const { return m_gap == 0.0; }

    double phi(double u) const
    {
        return m_gap < 0.0 ? std::copysign(m_width * std::cosh(u), u) : m_width * std::sinh(u);
    }
    double uAt(double phi) const { return m_gap < 0.0 ? std::acosh(phi / m_width) : std::asinh(phi / m_width); }
    double theta2(double u) const { return wrapToPi(m_centre + phi(u)); }

    // With s = b cos θ3, h = c - a sin θ2 and ' for d/dθ2:
    //     s θ3' = -a cos θ2             s' θ3' + s θ3'' = a sin θ2        s'' θ3' + 2 s' θ3'' + s θ3''' = a cos θ2
    //     s s'  = a h cos θ2            s s''' + 3 s' s'' = a cos θ2 (3 a sin θ2 - h)
    Rates at(double u) const
    {
        const Motion motion = m_motion.motionAt(phi(u)); // ω2 = 1: the angle is the time
        const double aSin = m_a * motion.crank.sin;
        const double aCos = m_a * motion.crank.cos;
        const double sJerk = (aCos * (4.0 * aSin - m_c) - 3.0 * motion.sDot * motion.sDDot) / motion.s;
        const double theta3Jerk =
            (aCos - motion.sDDot * motion.theta3Dot - 2.0 * motion.sDot * motion.theta3DDot) / motion.s;
        return {motion.plotted(),
                {motion.theta3Dot, motion.R4xDot, motion.theta3DDot, motion.R4xDDot, theta3Jerk, aSin + sJerk}};
    }

private:
    double m_a;
    double m_c;
    double m_centre;
    double m_gap;
    double m_width;
    ClosedForm m_motion;
};

using AllPoints = std::array<CriticalPoints, kCount>;

/// Adds the extrema between two values of u. Bisects each interval in which a slope changes its sign.
void addExtrema(const SteepPlace &place, double from, double to, AllPoints &points)
{
    constexpr double kCell = 0.1;
    constexpr int kFewestCells = 16;
    const int cells = std::max(kFewestCells, static_cast<int>(std::ceil((to - from) / kCell)));
    double left = from;
    Rates atLeft = place.at(left);
    for (int i = 1; i <= cells; ++i) {
        const double right = from + (to - from) * i / cells;
        const Rates atRight = place.at(right);
        for (std::size_t channel = 0; channel < kCount; ++channel) {
            const bool falls = atLeft.slope[channel] < 0.0;
            if (falls == (atRight.slope[channel] < 0.0)) {
                continue;
            }
            double low = left;
            double high = right;
            for (double u = std::midpoint(low, high); low < u && u < high; u = std::midpoint(low, high)) {
                ((place.at(u).slope[channel] < 0.0) == falls ? low : high) = u;
            }
            const double value = place.at(high).value[channel];
            if (std::isfinite(value)) {
                points[channel].push_back({place.theta2(high), value, CriticalPoint::Kind::Extremum});
            }
        }
        left = right;
        atLeft = atRight;
    }
}

/// Adds the limits of all channels on one side of an angle that the mechanism does not pass.
void addLimits(const SteepPlace &place, double u, AllPoints &points)
{
    const Rates rates = place.at(u);
    const double theta2 = place.theta2(place.isToggle() ? u : std::copysign(0.0, u));
    for (std::size_t channel = 0; channel < kCount; ++channel) {
        const bool isFinite = place.isToggle() || kPlottedChannels[channel].order == Order::Position;
        const double value = rates.value[channel];
        points[channel].push_back({theta2, isFinite ? value : std::copysign(kInfinity, value),
                                   u > 0.0 ? CriticalPoint::Kind::Begin : CriticalPoint::Kind::End});
    }
}

/// Adds all critical points with |φ| <= reach.
void addPoints(const SteepPlace &place, double reach, AllPoints &points)
{
    const double end = place.uAt(reach);
    if (place.isPassed()) {
        addExtrema(place, -end, end, points);
        return;
    }
    // At this distance positions are accurate to rounding; nearer to the limit the crank angle has too few digits.
    constexpr double kBesideLimit = 1e-6;
    const double start =
        place.isToggle() ? kBesideToggle : std::max(kBesideLimit, std::sqrt(4.0 * kBesideToggle / place.nearest()));
    for (const double side : {-1.0, 1.0}) {
        addLimits(place, side * start, points);
        addExtrema(place, std::min(side * start, side * end), std::max(side * start, side * end), points);
    }
}

} // namespace

AllPoints findCriticalPoints(const Mechanism &mechanism)
{
    AllPoints points;
    const MotionConstants k(mechanism);
    const double below = -k.side * kQuarterTurn; // p = ε there, and m = β opposite (motion_constants.h)
    const SteepPlace placeBelow(mechanism, below, k.epsilon / k.a);
    const SteepPlace placeAbove(mechanism, -below, k.beta / k.a);
    // The two searches meet half way and overlap a little, so that no extremum is missed, although some are found
    // twice.
    const double half = 0.5 * (0.5 * kTurn - placeBelow.nearest() - placeAbove.nearest());
    if (!(half > 0.0)) {
        return points; // cannot be assembled, or locked
    }
    const double overlap = std::min(0.1, 0.1 * half);
    addPoints(placeBelow, placeBelow.nearest() + half + overlap, points);
    addPoints(placeAbove, placeAbove.nearest() + half + overlap, points);
    for (std::size_t i = 0; i < kCount; ++i) {
        std::ranges::stable_sort(points[i], {}, &CriticalPoint::theta2);
        for (CriticalPoint &point : points[i]) {
            for (int order = 0; order < static_cast<int>(kPlottedChannels[i].order); ++order) {
                point.value *= mechanism.omega2();
            }
        }
    }
    return points;
}

} // namespace slidercrank
