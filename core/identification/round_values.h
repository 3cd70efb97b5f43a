// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The round values that a person may have chosen for the parameters.

#include "core/identification/last_fit.h"

namespace slidercrank
{

/// Rounds the lengths, ω2 (in rad/s, °/s or rpm) and θ20 (in ° or rad) of a last fit together. If they do not explain
/// the file as well, with the origins of the fit, tries again as if the standard errors were a tenth and a hundredth of
/// what they are; if none of these explains the file as well, returns `unrounded`, the parameters of the fit at t = 0
/// of the file.
Parameters roundedParameters(const LastFit &lastFit, const Parameters &unrounded);

/// If a fit has free origins, moves its parameters, and the origin of θ2, to numbers that a person may have chosen
/// (RoundNumber::isChosen), and the other origins to the values that suit these. Does nothing if the result does not
/// explain the file as well. (An origin depends on the lengths: if a coupler is 0.3 mm longer and the origin 0.3 mm
/// farther away, the positions in the file are nearly the same.) Free origins include θ20 of a model that follows the
/// angle in the file. `unrounded`: the parameters of the fit at t = 0 of the file.
void moveToChosenNumbers(LastFit &lastFit, const Parameters &unrounded);

} // namespace slidercrank
