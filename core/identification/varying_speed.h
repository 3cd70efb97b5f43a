// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the parameters found in a file over the time would change if the speed of the crank had varied.

#include "core/identification/last_fit.h"

namespace slidercrank
{

/// The speed of a motor varies with the load, once per turn, so that the angle of the crank has a ripple. Without θ2, a
/// file over the time shows a ripple only as residuals, because other lengths imitate most of it.
///
/// Returns by how much each parameter of the last fit would change if the angle had the ripple that explains the
/// residuals best (magnitudes in mm, rad and s, to first order). All are 0 if no ripple explains at least half of the
/// residuals (rms), or if the model follows the θ2 of the file.
ParameterErrors changesByRipple(const LastFit &lastFit);

} // namespace slidercrank
