// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Corrects the meanings of headings that the values of the columns disprove.

#include "core/import/raw_table.h"

namespace slidercrank
{

/// Corrects, before the time or crank angle is known:
///
///     θ, without a unit   in radians, if its values are those of radians: 0, 0.2618, … 6.2832
///     y, v                v is the velocity of y, if y changes and no column is x: the slider moves upright
///     θ1, θ2, θ3          the angles of crank, coupler and slider, if θ1 spans more than half a turn
void correctMeanings(RawTable &table);

} // namespace slidercrank
