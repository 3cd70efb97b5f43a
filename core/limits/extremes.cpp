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

/// Returns the crank angles at which a derivative of this order is unbounded: the limit positions of a rocker, and for
/// accelerations an exact toggle, where the velocities jump.
std::vector<PeakPlace> unboundedPlaces(const Mechanism &mechanism, Order order)
{
    const MotionConstants k(mechanism);
    const double below = -k.side * kQuarterTurn; // p = ε there, and m = β opposite (motion_constants.h)
    std::vector<PeakPlace> places;
    if (k.epsilon < 0.0) {
        for (const CrankRange &range : motionLimits(mechanism).ranges) {
            places.push_back({range.from, kInfinity});
            places.push_back({wrapToPi(range.to), kInfinity});
        }
    } else if (order == Order::Acceleration) {
        for (const auto &[gap, theta2] : {std::pair(k.epsilon, below), std::pair(k.beta, -below)}) {
            if (gap == 0.0) {
                places.push_back({theta2, kInfinity});
            }
        }
    }
    return places;
}

/// Returns the points of the largest magnitude, equal except for rounding.
std::vector<PeakPlace> largestPlaces(const CriticalPoints &points)
{
    constexpr double kSameValue = 1e-12; // relative
    constexpr double kSamePlace = 1e-10; // rad
    double largest = 0.0;
    for (const CriticalPoint &point : points) {
        largest = std::max(largest, std::abs(point.value));
    }
    std::vector<PeakPlace> places;
    for (const CriticalPoint &point : points) {
        const auto isNear = [&point](const PeakPlace &place) {
            return std::abs(std::remainder(place.theta2 - point.theta2, kTurn)) < kSamePlace;
        };
        if (std::abs(point.value) >= largest * (1.0 - kSameValue) && std::ranges::none_of(places, isNear)) {
            places.push_back({point.theta2, point.value});
        }
    }
    return places;
}

} // namespace

std::vector<Peak> motionPeaks(const Mechanism &mechanism)
{
    const Mobility mobility = motionLimits(mechanism).mobility;
    if (mobility == Mobility::Impossible || mobility == Mobility::Locked) {
        return {};
    }
    const std::array<CriticalPoints, kPlottedChannels.size()> points = findCriticalPoints(mechanism);
    std::vector<Peak> peaks;
    for (const Channel channel : {Channel{R4x, Order::Velocity},
                                  {R4x, Order::Acceleration},
                                  {Theta3, Order::Velocity},
                                  {Theta3, Order::Acceleration}}) {
        Peak peak{channel, 0.0, {}};
        const bool turnsUniformly =
            MotionConstants(mechanism).beta == 0.0 && channel == Channel{Theta3, Order::Velocity};
        if (mechanism.omega2() != 0.0) {
            peak.places = unboundedPlaces(mechanism, channel.order);
            if (peak.places.empty() && turnsUniformly) { // a = b, c = 0: θ3 is ±θ2 or differs from it by a right angle
                peak.magnitude = std::abs(mechanism.omega2());
            } else if (peak.places.empty()) {
                const auto index = std::ranges::find(kPlottedChannels, channel) - kPlottedChannels.begin();
                peak.places = largestPlaces(points[static_cast<std::size_t>(index)]);
            }
        }
        std::ranges::sort(peak.places, {}, &PeakPlace::theta2);
        for (const PeakPlace &place : peak.places) {
            peak.magnitude = std::max(peak.magnitude, std::abs(place.value));
        }
        peaks.push_back(peak);
    }
    return peaks;
}

} // namespace slidercrank
