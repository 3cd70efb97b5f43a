// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The state of a rocker at the ends of its arcs. There the coupler is perpendicular to the slider's line, and the
// velocities are infinite. Crank angles are rounded, so that the closed form has huge velocities just before an end,
// and no position just beyond it. Lengths in mm, angles in rad, time in s.

#include "core/closed_form/closed_form.h"
#include "core/limits/mobility.h"
#include "core/limits/output_channel.h"

#include <optional>

namespace slidercrank
{

/// Returns the motion if the crank is at the end of an arc at time t (s), except for rounding; otherwise nullopt. The
/// position is the limit position. Velocities do not exist (Status::Singular) unless the crank stands still. θ3 is
/// within [-π/2, 3π/2], as in closed_form.h. `limits`: motionLimits(mechanism); `alpha2`: crank acceleration, rad/s².
std::optional<Motion> crankLimitMotionAt(const Mechanism &mechanism, const MotionLimits &limits, double t,
                                         double alpha2);

/// Returns all channels of crankLimitMotionAt().
std::optional<OutputState> crankLimitStateAt(const Mechanism &mechanism, const MotionLimits &limits, double t,
                                             double alpha2);

} // namespace slidercrank
