// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/observations.h"

#include <optional>

namespace slidercrank
{

/// How fast the crank turns, rad/s.
struct CrankSpeedChange {
    double atStart = 0.0;
    double atEnd = 0.0;
};

/// The crank's speed at the first and last rows, where θ2 does not advance evenly.
std::optional<CrankSpeedChange> unevenCrankOf(const Observations &all);

} // namespace slidercrank
