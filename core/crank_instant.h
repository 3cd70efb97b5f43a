// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// "At θ2 = 60°": the instant at which the crank passes an angle.

#include "core/mechanism.h"

#include <optional>

namespace slidercrank
{

/// The first instant (s) at or after `start` at which θ2 = degrees, whole turns apart. None when the crank stands still
/// elsewhere, or when the instant is too far away to be a number.
std::optional<double> instantAtCrankAngle(const Mechanism &mechanism, double degrees, double start);

} // namespace slidercrank
