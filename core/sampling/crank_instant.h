// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// "At θ2 = 60°": the instant at which the crank passes an angle.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

#include <optional>

namespace slidercrank
{

/// The first instant (s) at or after `start` at which θ2 = degrees, whole turns apart. None when the crank stands still
/// elsewhere, or when the instant is too far away to be a number.
std::optional<double> instantAtCrankAngle(const Mechanism &mechanism, double degrees, double start);

/// The instant (s) of the run at which the crank is at that angle (rad), whole turns apart, nearest to t, which is one
/// of the run's; where the crank never comes there, the end of the run at which it is nearer to it. t itself when the
/// crank stands still.
double nearestInstantAtCrankAngle(const Mechanism &mechanism, const Sampling &run, double theta2, double t);

} // namespace slidercrank
