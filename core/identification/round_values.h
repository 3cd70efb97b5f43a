// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The round numbers that a person may have chosen for the parameters.

#include "core/identification/last_fit.h"

#include <span>

namespace slidercrank
{

/// The number with the fewest digits within three standard errors of a value, in any of some units; 0 if that is within
/// them. It is accepted only if such a round number is there by chance with a probability of at most 10 %. Otherwise
/// returns the value, rounded to two digits of the standard error in the first unit. Returns the value itself if its
/// standard error is 0, infinite or NaN.
double roundest(double value, double standardError, std::span<const double> units);

/// Rounds a length (mm) like roundest(), in a unit of `unit` mm.
double roundLength(double value, double standardError, double unit);

/// Rounds the lengths, ω2 (in rad/s, °/s or rpm) and θ20 (in ° or rad) of a last fit, as far as they explain the file
/// as well. `exact`: the parameters without rounding. `lengthUnit`: of the lengths in the file, mm.
Parameters roundedParameters(const LastFit &lastFit, const Parameters &exact, double lengthUnit);

} // namespace slidercrank
