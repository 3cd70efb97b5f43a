// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Recognizes columns that were not measured or simulated, but computed from fewer values.

#include "core/identification/observations.h"

namespace slidercrank
{

/// Marks columns of all rows of a file:
/// - Columns of derivatives that contain central, forward or backward difference quotients of a lower column within
///   the rounding of both, apart from a constant factor: the speed of the crank, in a table over its angle.
/// - Columns that were interpolated linearly between fewer rows, or hold the last of fewer values: nearly half of the
///   values or more repeat the one before or lie on the straight line through their neighbours, within rounding,
///   although the other values show that the column is curved.
Observations withComputedColumnsMarked(Observations observations);

} // namespace slidercrank
