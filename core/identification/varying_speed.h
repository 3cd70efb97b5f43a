// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a file over the time would say about the mechanism if the speed of the crank varied.

#include "core/identification/last_fit.h"

namespace slidercrank
{

/// The speed of a motor varies with the load, once per turn. Without θ2, a file over the time shows that only as
/// systematic residuals, while other lengths imitate most of it. Returns by how much each parameter of the last fit
/// would change (its magnitude, in mm, rad and s) if the angle of the crank had a ripple. All are 0 if a ripple does
/// not explain the residuals, or if the file contains θ2.
ParameterErrors changesByRipple(const LastFit &lastFit);

} // namespace slidercrank
