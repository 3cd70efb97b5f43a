// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The time at which the crank passes a given angle.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

#include <optional>

namespace slidercrank
{

/// The first time (s) at or after `start` at which the crank has the angle theta2 (rad) but for whole turns. None when
/// the crank stands still at another angle, or when the time is too large for a number.
std::optional<double> instantAtCrankAngle(const Mechanism &mechanism, double theta2, double start);

/// The time (s) within the sampled duration at which the crank has that angle (rad) but for whole turns, nearest to t,
/// which lies within it; where the crank does not reach the angle, the end at which it is nearer to it. t itself when
/// the crank stands still.
double nearestInstantAtCrankAngle(const Mechanism &mechanism, const Sampling &sampling, double theta2, double t);

} // namespace slidercrank
