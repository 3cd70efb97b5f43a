// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/extremes.h"

#include "core/closed_form/motion_constants.h"
#include "core/limits/critical_points.h"
#include "core/limits/mobility.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::array<Channel, 4> kRates{
    {{R4x, Order::Velocity}, {R4x, Order::Acceleration}, {Theta3, Order::Velocity}, {Theta3, Order::Acceleration}}};

const CriticalPoints &courseOf(Channel channel, const std::array<CriticalPoints, kPlottedChannels.size()> &courses)
{
    return courses[static_cast<std::size_t>(std::ranges::find(kPlottedChannels, channel) - kPlottedChannels.begin())];
}

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

    Peak peak(Channel channel) const
    {
        Peak peak{channel, m_magnitude, m_places};
        std::ranges::sort(peak.places, {}, &PeakPlace::theta2);
        return peak;
    }

private:
    double m_magnitude = 0.0;
    std::vector<PeakPlace> m_places;
};

} // namespace

std::vector<Peak> motionPeaks(const Mechanism &mechanism)
{
    const MotionLimits limits = motionLimits(mechanism);
    const MotionConstants lengths(mechanism);
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
            ends.push_back({wrapToPi(range.to), kInfinity});
        }
        std::ranges::sort(ends, {}, &PeakPlace::theta2);
        for (const Channel &channel : kRates) {
            peaks.push_back({channel, kInfinity, ends});
        }
        return peaks;
    }

    // p = ε at -g 90°, m = β at +g 90° (motion_constants.h)
    const double below = -lengths.side * kQuarterTurn;
    const bool togglesBelow = lengths.epsilon == 0.0;
    const bool togglesAbove = lengths.beta == 0.0;
    const std::array<CriticalPoints, kPlottedChannels.size()> courses = findCriticalPoints(mechanism);

    std::vector<PeakPlace> toggles;
    if (togglesBelow) {
        toggles.push_back({below, kInfinity});
    }
    if (togglesAbove) {
        toggles.push_back({-below, kInfinity});
    }
    std::ranges::sort(toggles, {}, &PeakPlace::theta2);
    for (const Channel &channel : kRates) {
        if (channel.order == Order::Acceleration && !toggles.empty()) {
            peaks.push_back({channel, kInfinity, toggles});
        } else if (channel.coordinate == Theta3 && togglesAbove) {
            peaks.push_back({channel, std::abs(mechanism.omega2()), {}}); // θ3 = ±θ2 or a right angle apart from it
        } else {
            Largest largest;
            for (const CriticalPoint &point : courseOf(channel, courses)) {
                largest.offer(point.theta2, point.value);
            }
            peaks.push_back(largest.peak(channel));
        }
    }
    return peaks;
}

} // namespace slidercrank
