// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/crank_limit.h"

#include "core/mechanism/turn.h"
#include "core/mechanism/two_part_angle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

/// Returns the limit position with this crank angle (rad), except for rounding, or nullptr.
const SliderPosition *crankLimitAt(const MotionLimits &limits, double theta2)
{
    // Angles near 1 rad have errors of some 1e-16 rad; a large angle has at most half a unit of its last digit, ε θ2.
    const double rounding = std::max(1e-12, 4.0 * std::numeric_limits<double>::epsilon() * std::abs(theta2)); // rad
    for (const SliderPosition &limit : limits.crankLimits) {
        if (std::abs(wrapToPi(theta2 - limit.theta2)) <= rounding) {
            return &limit;
        }
    }
    return nullptr;
}

/// Returns the coordinates with the coupler perpendicular to the slider's line. θ3 is within [-π/2, 3π/2], as in
/// closed_form.h.
Vector12 limitCoordinates(const Mechanism &mechanism, const SliderPosition &limit, double theta2)
{
    const bool isAbovePin = mechanism.c() > mechanism.a() * std::sin(theta2); // B above A
    const double pinHeight = isAbovePin ? mechanism.c() - mechanism.b() : mechanism.c() + mechanism.b();
    const double downwards = mechanism.branch() == Branch::Open ? -kQuarterTurn : 3.0 * kQuarterTurn;
    Vector12 q;
    setCoordinates(q, {.R2x = 0.5 * limit.R4x,
                       .R2y = 0.5 * pinHeight,
                       .theta2 = theta2,
                       .R3x = limit.R4x,
                       .R3y = 0.5 * (pinHeight + mechanism.c()),
                       .theta3 = isAbovePin ? kQuarterTurn : downwards,
                       .R4x = limit.R4x,
                       .R4y = mechanism.c()});
    return q;
}

} // namespace

std::optional<OutputState> crankLimitStateAt(const Mechanism &mechanism, const MotionLimits &limits, double t,
                                             double alpha2)
{
    const double theta2 = crankAngle(mechanism.omega2(), t, mechanism.theta20()).hi;
    const SliderPosition *limit = crankLimitAt(limits, theta2);
    if (!limit) {
        return std::nullopt;
    }
    OutputState output{State{limitCoordinates(mechanism, *limit, theta2), Vector12::Zero(), Vector12::Zero()}, {}};
    const bool isAtRest = mechanism.omega2() == 0.0 && alpha2 == 0.0;
    output.state.setStatus(isAtRest ? Status::Solved : Status::Singular);
    output.derived = derivedState(mechanism, output.state, 0.0);
    return output;
}

} // namespace slidercrank
