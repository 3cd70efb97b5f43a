// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Recognizes columns that were not measured or simulated, but computed from a different column or from fewer values.

#include "core/identification/observations.h"

namespace slidercrank
{

/// Sets `isDifference`, `isPrintedDifference` and `isInterpolated` of each column. The observations must have all rows
/// of the file, because only neighbouring rows show how a column was computed.
/// - isDifference: a derivative that contains central, forward or backward difference quotients of a column of lower
///   order of the same coordinate, or such quotients of them, within the rounding of both columns. A constant factor
///   may lie between them: in a table over the crank angle, the quotients are taken by the angle and have to be
///   multiplied by the speed of the crank.
/// - isPrintedDifference: a difference that was computed from the printed values of the column of lower order. It
///   repeats their quotients more exactly than a derivative could, so that it is certainly no derivative.
/// - isInterpolated: a column that was interpolated linearly between fewer rows, or repeats each of fewer values until
///   the next one. Nearly half of its values or more lie on the straight line through their neighbours, within
///   rounding, or repeat the value before, although the other values show that the column is curved.
Observations withComputedColumnsMarked(Observations observations);

} // namespace slidercrank
