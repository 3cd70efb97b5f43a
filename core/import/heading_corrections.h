// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Corrects the meanings of headings that the values of the columns disprove.

#include "core/import/raw_table.h"

namespace slidercrank
{

/// Corrects, before the time or crank angle is known:
///
///     θ, without a unit   in radians, if its values are those of radians: 0, 0.2618, … 6.2832
///     y, v            beside a y that changes without an x, the velocity is that of y: the slider is upright
///     θ1, θ2, θ3      those of crank, coupler and slider, if θ1 makes half a turn
void correctMeanings(RawTable &table);

} // namespace slidercrank
