// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/extremes.h"

#include "core/limits/critical_points.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Returns the candidates whose magnitude is `largest` except for rounding.
std::vector<PeakPoint> findPeakPoints(const CriticalPoints &candidates, double largest)
{
    constexpr double kValueTolerance = 1e-12; // relative
    constexpr double kAngleTolerance = 1e-10; // rad
    std::vector<PeakPoint> peakPoints;
    for (const CriticalPoint &candidate : candidates) {
        const auto isNear = [&candidate](const PeakPoint &point) {
            return std::abs(std::remainder(point.theta2 - candidate.theta2, kTurn)) < kAngleTolerance;
        };
        if (std::abs(candidate.value) >= largest * (1.0 - kValueTolerance) &&
            std::ranges::none_of(peakPoints, isNear)) {
            peakPoints.push_back({.theta2 = candidate.theta2, .value = candidate.value});
        }
    }
    return peakPoints;
}

} // namespace

std::vector<Peak> motionPeaks(const Mechanism &mechanism)
{
    std::vector<Peak> peaks;
    std::array<CriticalPoints, kPlottedChannels.size()> points = findCriticalPoints(mechanism);
    const bool turnsUniformly = mechanism.a() == mechanism.b() && mechanism.c() == 0.0; // θ3 = ±θ2 + n π
    for (const Channel channel : kPeakChannels) {
        CriticalPoints &channelPoints = points[plottedIndexOf(channel)];
        if (channelPoints.empty()) {
            return {};
        }
        Peak peak{.channel = channel};
        for (CriticalPoint &point : channelPoints) {
            const bool isLimitOfMotion =
                point.kind != CriticalPoint::Kind::Extremum; // there the velocity jumps or is infinite
            const bool isUnbounded = isLimitOfMotion && channel.order == Order::Acceleration;
            point.value = isUnbounded || std::isinf(point.value) ? kInfinity : point.value;
            peak.magnitude = std::max(peak.magnitude, std::abs(point.value));
        }
        const bool isConstant = turnsUniformly && channel == Channel{Theta3, Order::Velocity};
        if (isConstant || mechanism.omega2() == 0.0) {
            peak.magnitude = std::abs(mechanism.omega2());
        } else {
            peak.points = findPeakPoints(channelPoints, peak.magnitude);
        }
        peaks.push_back(peak);
    }
    return peaks;
}

} // namespace slidercrank
