// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Chooses the range of an axis.

#include "ui/text/interval.h"

namespace slidercrank
{

/// Returns the range, widened a little and rounded outwards, so that small changes of the values do not move the axis.
/// A lower end of 0 remains 0. A range of length zero is widened on both sides, also at 0.
Interval roundedOutwards(const Interval &range);

} // namespace slidercrank
