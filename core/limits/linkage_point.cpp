// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/linkage_point.h"

#include "core/limits/crank_limit.h"

#include <algorithm>
#include <optional>

namespace slidercrank
{

LinkageMotion linkageMotion(const Mechanism &mechanism, double t, double alpha2)
{
    const std::optional<OutputState> limit = crankLimitStateAt(mechanism, motionLimits(mechanism), t, alpha2);
    const State state = limit ? limit->state : outputStateAt(mechanism, t, alpha2).state;
    const auto motionFrom = [&state](Coordinate x, Coordinate y, double factor) {
        const auto vectorOf = [&](const Vector12 &q) { return PlaneVector{factor * q[x], factor * q[y]}; };
        return PointMotion{
            .position = vectorOf(state.q), .velocity = vectorOf(state.qDot), .acceleration = vectorOf(state.qDDot)};
    };
    const auto motionOfPoint = [&motionFrom](LinkagePoint point) {
        switch (point) {
        case LinkagePoint::A: return motionFrom(R2x, R2y, 2.0); // R2 is the midpoint of O2-A
        case LinkagePoint::B: return motionFrom(R4x, R4y, 1.0);
        case LinkagePoint::G3: break;
        }
        return motionFrom(R3x, R3y, 1.0);
    };
    LinkageMotion motion;
    std::ranges::transform(kLinkagePoints, motion.begin(), motionOfPoint);
    return motion;
}

} // namespace slidercrank
