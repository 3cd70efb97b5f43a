// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/critical_points.h"

#include "core/closed_form/motion_constants.h"
#include "core/closed_form/closed_form.h"
#include "core/mechanism/turn.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kBeside = 1e-15; // rad beside an exact toggle
constexpr std::size_t kCount = kPlottedChannels.size();

/// The channels at one crank angle for ω2 = 1, and how they change with the angle.
struct Rates {
    std::array<double, kCount> value;
    std::array<double, kCount> slope;
};

/// What happens about a crank angle at which the coupler is steepest, ±90°. Where the coupler passes there, the angle
/// from there is φ = w sinh u: with w = √(2·gap/a), where b cos θ3 ∝ √(gap + a φ²/2), everything that happens takes
/// about a unit of u, however small the gap is. Where it does not, it comes as near as φ₀, with cos φ₀ = 1 + gap/a, and
/// φ = ±φ₀ cosh u does the same.
class SteepPlace
{
public:
    /// `gap`: how much longer the coupler is than it takes to pass there, in units of `a`.
    SteepPlace(const Mechanism &mechanism, double centre, double gap)
        : m_a(mechanism.a())
        , m_c(mechanism.c())
        , m_centre(centre)
        , m_gap(gap)
        , m_width(gap > 0.0   ? std::min(1.0, std::sqrt(2.0 * gap))
                  : gap < 0.0 ? 2.0 * std::asin(std::sqrt(-0.5 * gap))
                              : 1.0)
        , m_motion(Mechanism({mechanism.a(), mechanism.b(), mechanism.c(), 1.0, centre, mechanism.branch()}))
    {
    }

    /// How near it the motion comes, rad.
    double nearest() const { return m_gap < 0.0 ? m_width : 0.0; }

    bool isPassed() const { return m_gap > 0.0; }
    bool isToggle() const { return m_gap == 0.0; }

    double phi(double u) const
    {
        return m_gap < 0.0 ? std::copysign(m_width * std::cosh(u), u) : m_width * std::sinh(u);
    }
    double uAt(double angle) const { return m_gap < 0.0 ? std::acosh(angle / m_width) : std::asinh(angle / m_width); }
    double theta2(double angle) const { return wrapToPi(m_centre + angle); }

    // With s = b cos θ3 and h = c - a sin θ2, and a dash for d/dθ2:
    //     s θ3' = -a cos θ2             s' θ3' + s θ3'' = a sin θ2        s'' θ3' + 2 s' θ3'' + s θ3''' = a cos θ2
    //     s s'  = a h cos θ2            s s''' + 3 s' s'' = a cos θ2 (3 a sin θ2 - h)
    Rates at(double angle) const
    {
        const Motion motion = m_motion.motionAt(angle);
        const double sine = motion.crank.sin;
        const double aCos = m_a * motion.crank.cos;
        const double h = m_c - m_a * sine;
        const double sJerk = (aCos * (3.0 * m_a * sine - h) - 3.0 * motion.sDot * motion.sDDot) / motion.s;
        const double theta3Jerk =
            (aCos - motion.sDDot * motion.theta3Dot - 2.0 * motion.sDot * motion.theta3DDot) / motion.s;
        return {{motion.theta3, motion.R4x, motion.theta3Dot, motion.R4xDot, motion.theta3DDot, motion.R4xDDot},
                {motion.theta3Dot, motion.R4xDot, motion.theta3DDot, motion.R4xDDot, theta3Jerk, m_a * sine + sJerk}};
    }

    /// The u at which that slope changes its sign, between two at which the signs differ.
    double turningPoint(std::size_t channel, double low, double high, double atLow, double atHigh) const
    {
        if (!(std::min(atLow, atHigh) < 0.0 && std::max(atLow, atHigh) > 0.0)) {
            return atLow == 0.0 ? low : high; // or not a number
        }
        const auto isClose = [](double from, double to) {
            return to - from <= 4.0 * std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(from));
        };
        std::uintmax_t most = 80;
        const auto slopeAt = [&](double u) {
            const double slope = at(phi(u)).slope[channel];
            return std::isfinite(slope) ? slope : 0.0;
        };
        return boost::math::tools::toms748_solve(slopeAt, low, high, atLow, atHigh, isClose, most).second;
    }

private:
    double m_a;
    double m_c;
    double m_centre;
    double m_gap;
    double m_width;
    ClosedForm m_motion; ///< with the angle for the time
};

using Courses = std::array<CriticalPoints, kCount>;

/// From one u to another, one sign of φ.
void searchTurns(const SteepPlace &place, double from, double to, Courses &courses)
{
    constexpr double kCell = 0.1;
    constexpr int kFewestCells = 16;
    const int cells = std::max(kFewestCells, static_cast<int>(std::ceil((to - from) / kCell)));
    double low = from;
    Rates atLow = place.at(place.phi(low));
    for (int i = 1; i <= cells; ++i) {
        const double high = from + (to - from) * i / cells;
        const Rates atHigh = place.at(place.phi(high));
        for (std::size_t channel = 0; channel < kCount; ++channel) {
            if ((atLow.slope[channel] < 0.0) != (atHigh.slope[channel] < 0.0)) {
                const double angle =
                    place.phi(place.turningPoint(channel, low, high, atLow.slope[channel], atHigh.slope[channel]));
                const double value = place.at(angle).value[channel];
                if (std::isfinite(value)) {
                    courses[channel].push_back({place.theta2(angle), value, CriticalPoint::Kind::Extremum});
                }
            }
        }
        low = high;
        atLow = atHigh;
    }
}

/// The limits of all channels on one side of a place that is not passed.
void addLimit(const SteepPlace &place, double u, Courses &courses)
{
    const double angle = place.phi(u);
    const Rates rates = place.at(angle);
    const CriticalPoint::Kind kind = u > 0.0 ? CriticalPoint::Kind::Begin : CriticalPoint::Kind::End;
    for (std::size_t channel = 0; channel < kCount; ++channel) {
        const bool isFinite = place.isToggle() || kPlottedChannels[channel].order == Order::Position;
        const double value = rates.value[channel];
        courses[channel].push_back({place.theta2(angle), isFinite ? value : std::copysign(kUnbounded, value), kind});
    }
}

/// As far as that angle to either side.
void searchAbout(const SteepPlace &place, double reach, Courses &courses)
{
    const double end = place.uAt(reach);
    if (place.isPassed()) {
        searchTurns(place, -end, end, courses);
        return;
    }
    // Positions have as many digits there; nearer, the crank's angle has not.
    constexpr double kBesideLimit = 1e-6;
    const double start =
        place.isToggle() ? kBeside : std::max(kBesideLimit, std::sqrt(4.0 * kBeside / place.nearest()));
    for (const double side : {-1.0, 1.0}) {
        addLimit(place, side * start, courses);
        searchTurns(place, std::min(side * start, side * end), std::max(side * start, side * end), courses);
    }
}

/// Ascending, without what was found from both sides.
void putInOrder(CriticalPoints &course)
{
    constexpr double kSamePlace = 1e-10; // rad
    std::ranges::sort(course, [](const CriticalPoint &a, const CriticalPoint &b) {
        return a.theta2 != b.theta2 ? a.theta2 < b.theta2 : a.kind < b.kind;
    });
    const auto isSame = [](const CriticalPoint &a, const CriticalPoint &b) {
        return a.kind == CriticalPoint::Kind::Extremum && b.kind == CriticalPoint::Kind::Extremum &&
               std::abs(std::remainder(b.theta2 - a.theta2, kTurn)) < kSamePlace;
    };
    course.erase(std::unique(course.begin(), course.end(), isSame), course.end());
    if (course.size() > 1 && isSame(course.front(), course.back())) {
        course.pop_back();
    }
}

} // namespace

Courses findCriticalPoints(const Mechanism &mechanism)
{
    Courses courses;
    const MotionConstants lengths(mechanism);
    // p = ε at -g 90°, m = β at +g 90° (motion_constants.h)
    const double gapBelow = lengths.epsilon / lengths.a;
    const double gapAbove = lengths.beta / lengths.a;
    constexpr double kWholeCrank = -2.0;
    if (!(gapBelow > kWholeCrank && gapAbove > kWholeCrank)) {
        return courses; // no pose, or one
    }
    const double below = -lengths.side * kQuarterTurn;
    const SteepPlace placeBelow(mechanism, below, gapBelow);
    const SteepPlace placeAbove(mechanism, -below, gapAbove);
    // They meet in the middle, and a little beyond, so that nothing is lost in between.
    const double half = 0.5 * (0.5 * kTurn - placeBelow.nearest() - placeAbove.nearest());
    if (!(half > 0.0)) {
        return courses;
    }
    const double beyond = half + std::min(0.1, 0.1 * half);
    searchAbout(placeBelow, placeBelow.nearest() + beyond, courses);
    searchAbout(placeAbove, placeAbove.nearest() + beyond, courses);
    for (std::size_t i = 0; i < kCount; ++i) {
        putInOrder(courses[i]);
        const double omega = mechanism.omega2();
        const std::array<double, 3> factors{1.0, omega, omega * omega};
        for (CriticalPoint &point : courses[i]) {
            point.value *= factors[static_cast<std::size_t>(kPlottedChannels[i].order)];
        }
    }
    return courses;
}

} // namespace slidercrank
