// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/extremes.h"

#include "core/closed_form/clearance.h"
#include "core/closed_form/closed_form.h"
#include "core/limits/mobility.h"
#include "core/mechanism/turn.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::array<Channel, 4> kRates{
    {{R4x, Order::Velocity}, {R4x, Order::Acceleration}, {Theta3, Order::Velocity}, {Theta3, Order::Acceleration}}};

/// The four rates at one crank angle for ω2 = 1, and how they change with the angle.
struct Rates {
    std::array<double, kRates.size()> value;
    std::array<double, kRates.size()> slope;
};

/// Half a turn about a crank angle at which the coupler is steepest, ±90°, with a little more at both ends. The angle
/// from there is φ = w sinh u: with w = √(2·gap/a), where b cos θ3 ∝ √(gap + a φ²/2), everything that happens takes
/// about a unit of u, however small the gap is.
class HalfTurn
{
public:
    /// `gap`: how much longer the coupler is than it takes to pass there, in units of `a`.
    HalfTurn(const Mechanism &mechanism, double centre, double gap)
        : m_a(mechanism.a())
        , m_c(mechanism.c())
        , m_centre(centre)
        , m_width(gap > 0.0 ? std::min(1.0, std::sqrt(2.0 * gap)) : 1.0)
        , m_motion(Mechanism({mechanism.a(), mechanism.b(), mechanism.c(), 1.0, centre, mechanism.branch()}))
    {
    }

    double end() const { return std::asinh((kQuarterTurn + 0.1) / m_width); }
    double phi(double u) const { return m_width * std::sinh(u); }
    double theta2(double angle) const { return wrapped(m_centre + angle); }

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
        return {{motion.R4xDot, motion.R4xDDot, motion.theta3Dot, motion.theta3DDot},
                {motion.R4xDDot, m_a * sine + sJerk, motion.theta3DDot, theta3Jerk}};
    }

    /// The u at which that slope changes its sign, between two at which the signs differ.
    double turningPoint(std::size_t rate, double low, double high, double atLow, double atHigh) const
    {
        if (!(std::min(atLow, atHigh) < 0.0 && std::max(atLow, atHigh) > 0.0)) {
            return atLow == 0.0 ? low : high; // or not a number
        }
        const auto isClose = [](double from, double to) {
            return to - from <= 4.0 * std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(from));
        };
        std::uintmax_t most = 80;
        const auto slopeAt = [&](double u) {
            const double slope = at(phi(u)).slope[rate];
            return std::isfinite(slope) ? slope : 0.0;
        };
        return boost::math::tools::toms748_solve(slopeAt, low, high, atLow, atHigh, isClose, most).second;
    }

private:
    double m_a;
    double m_c;
    double m_centre;
    double m_width;
    ClosedForm m_motion; ///< with the angle for the time
};

/// Keeps the largest, and whatever equals it but for rounding.
class Largest
{
public:
    void offer(double theta2, double value)
    {
        constexpr double kSame = 1e-12;      // relative
        constexpr double kSamePlace = 1e-10; // rad: the half turns overlap
        const double magnitude = std::abs(value);
        if (!(magnitude > 0.0) || magnitude < m_magnitude * (1.0 - kSame)) {
            return;
        }
        if (magnitude > m_magnitude * (1.0 + kSame)) {
            m_places.clear();
        }
        m_magnitude = std::max(m_magnitude, magnitude);
        const bool known = std::any_of(m_places.begin(), m_places.end(), [&](const PeakPlace &place) {
            return std::abs(std::remainder(place.theta2 - theta2, kTurn)) < kSamePlace;
        });
        if (!known) {
            m_places.push_back({theta2, value});
        }
    }

    Peak peak(Channel channel, double omega2) const
    {
        const double factor = channel.order == Order::Velocity ? omega2 : omega2 * omega2;
        Peak peak{channel, std::abs(factor) * m_magnitude, m_places};
        for (PeakPlace &place : peak.places) {
            place.value *= factor;
        }
        std::ranges::sort(peak.places, {}, &PeakPlace::theta2);
        return peak;
    }

private:
    double m_magnitude = 0.0;
    std::vector<PeakPlace> m_places;
};

void searchHalfTurn(const HalfTurn &half, bool passesToggle, std::array<Largest, kRates.size()> &largest)
{
    constexpr double kCell = 0.1;
    const double end = half.end();
    const int cells = 2 * static_cast<int>(std::ceil(end / kCell)) + 1; // odd: a toggle is within one, not at its edge
    double low = -end;
    Rates atLow = half.at(half.phi(low));
    for (int i = 1; i <= cells; ++i) {
        const double high = end * (2.0 * i - cells) / cells;
        const Rates atHigh = half.at(half.phi(high));
        for (std::size_t rate = 0; rate < kRates.size(); ++rate) {
            if ((atLow.slope[rate] < 0.0) != (atHigh.slope[rate] < 0.0)) {
                const double angle =
                    half.phi(half.turningPoint(rate, low, high, atLow.slope[rate], atHigh.slope[rate]));
                largest[rate].offer(half.theta2(angle), half.at(angle).value[rate]);
            }
        }
        low = high;
        atLow = atHigh;
    }
    if (passesToggle) {
        // The speeds jump there, from one limit to another: both are as good as reached.
        constexpr double kBeside = 1e-15; // rad
        for (const double angle : {-kBeside, kBeside}) {
            const Rates beside = half.at(angle);
            for (std::size_t rate = 0; rate < kRates.size(); ++rate) {
                largest[rate].offer(half.theta2(angle), beside.value[rate]);
            }
        }
    }
}

} // namespace

std::vector<Peak> motionPeaks(const Mechanism &mechanism)
{
    const MotionLimits limits = motionLimits(mechanism);
    const Clearance lengths(mechanism);
    switch (limits.mobility) {
    case Mobility::Impossible:
    case Mobility::Locked: return {};
    case Mobility::Rocker:
    case Mobility::FullTurn: break;
    }
    std::vector<Peak> peaks;
    if (mechanism.omega2() == 0.0) {
        for (const Channel &channel : kRates) {
            peaks.push_back({channel, 0.0, {}});
        }
        return peaks;
    }
    if (limits.mobility == Mobility::Rocker) {
        std::vector<PeakPlace> ends;
        for (const CrankRange &range : limits.ranges) {
            ends.push_back({range.from, kInfinity});
            ends.push_back({wrapped(range.to), kInfinity});
        }
        std::ranges::sort(ends, {}, &PeakPlace::theta2);
        for (const Channel &channel : kRates) {
            peaks.push_back({channel, kInfinity, ends});
        }
        return peaks;
    }

    // p = ε at -g 90°, m = β at +g 90° (clearance.h)
    const double below = -lengths.side() * kQuarterTurn;
    const bool togglesBelow = lengths.epsilon() == 0.0;
    const bool togglesAbove = lengths.beta() == 0.0;
    std::array<Largest, kRates.size()> largest;
    searchHalfTurn(HalfTurn(mechanism, below, lengths.epsilon() / lengths.a()), togglesBelow, largest);
    searchHalfTurn(HalfTurn(mechanism, -below, lengths.beta() / lengths.a()), togglesAbove, largest);

    std::vector<PeakPlace> toggles;
    if (togglesBelow) {
        toggles.push_back({below, kInfinity});
    }
    if (togglesAbove) {
        toggles.push_back({-below, kInfinity});
    }
    std::ranges::sort(toggles, {}, &PeakPlace::theta2);
    for (std::size_t rate = 0; rate < kRates.size(); ++rate) {
        const Channel channel = kRates[rate];
        if (channel.order == Order::Acceleration && !toggles.empty()) {
            peaks.push_back({channel, kInfinity, toggles});
        } else if (channel.coordinate == Theta3 && togglesAbove) {
            peaks.push_back({channel, std::abs(mechanism.omega2()), {}}); // θ3 = ±θ2 or a right angle apart from it
        } else {
            peaks.push_back(largest[rate].peak(channel, mechanism.omega2()));
        }
    }
    return peaks;
}

} // namespace slidercrank
