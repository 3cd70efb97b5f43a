// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the time at which the crank passes a given angle.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

#include <optional>

namespace slidercrank
{

/// Returns the first time (s) at or after `start` at which the crank angle is theta2 (rad) modulo 2π, or nullopt if the
/// crank does not turn and is at a different angle, or if the time is not a finite number.
std::optional<double> timeAtCrankAngle(const Mechanism &mechanism, double theta2, double start);

/// Returns the time (s) nearest to t within the sampled time span at which the crank angle is theta2 (rad) modulo 2π.
/// If the crank does not reach the angle, returns the end of the time span at which the crank is nearer to it. Returns
/// t if the crank does not turn. Requires t to be within the time span.
double nearestTimeAtCrankAngle(const Mechanism &mechanism, const Sampling &sampling, double theta2, double t);

} // namespace slidercrank
