// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/crank_limit.h"

#include "core/closed_form/state_at.h"
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
    // Both angles have errors of a few ε |θ2|, and of a few ε where θ2 is a difference of larger angles.
    constexpr double kMinRounding = 1e-12; // rad
    const double rounding = std::max(kMinRounding, 4.0 * std::numeric_limits<double>::epsilon() * std::abs(theta2));
    for (const SliderPosition &limit : limits.crankLimits) {
        if (std::abs(wrapToPi(theta2 - limit.theta2)) <= rounding) {
            return &limit;
        }
    }
    return nullptr;
}

} // namespace

std::optional<Motion> crankLimitMotionAt(const Mechanism &mechanism, const MotionLimits &limits, double t,
                                         double alpha2)
{
    const double theta2 = crankAngle(mechanism.omega2(), t, mechanism.theta20()).hi;
    const SliderPosition *limit = crankLimitAt(limits, theta2);
    if (!limit) {
        return std::nullopt;
    }
    // The pin A is exactly below or above B.
    const bool isBAboveA = mechanism.c() > mechanism.a() * std::sin(theta2);
    const double pinHeight = isBAboveA ? mechanism.c() - mechanism.b() : mechanism.c() + mechanism.b();
    const double theta3Downwards = mechanism.branch() == Branch::Open ? -kQuarterTurn : 3.0 * kQuarterTurn;
    Motion motion{.theta2 = theta2,
                  .crank = {.sin = pinHeight / mechanism.a(), .cos = limit->R4x / mechanism.a()},
                  .s = 0.0,
                  .theta3 = isBAboveA ? kQuarterTurn : theta3Downwards,
                  .R4x = limit->R4x,
                  .status = Status::Singular};
    if (mechanism.omega2() == 0.0 && alpha2 == 0.0) {
        motion.sDot = motion.sDDot = 0.0;
        motion.theta3Dot = motion.theta3DDot = 0.0;
        motion.R4xDot = motion.R4xDDot = 0.0;
        motion.status = Status::Solved;
    }
    return motion;
}

std::optional<OutputState> crankLimitStateAt(const Mechanism &mechanism, const MotionLimits &limits, double t,
                                             double alpha2)
{
    const std::optional<Motion> motion = crankLimitMotionAt(mechanism, limits, t, alpha2);
    if (!motion) {
        return std::nullopt;
    }
    OutputState output{stateOf(mechanism, *motion), {}};
    output.derived = derivedState(mechanism, output.state, motion->s);
    return output;
}

} // namespace slidercrank
