// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Evenly spaced time stamps or crank angles, as they were before somebody rounded them.

#include "core/identification/observations.h"

#include <vector>

namespace slidercrank
{

/// Values of one spacing, some of which may be missing.
struct EvenGrid {
    Values values;

    // How far the first value and the distance from the first to the last one can differ so that rounding still
    // explains the printed values; 0 if rounding explains none of them.
    double startMargin = 0.0;
    double durationMargin = 0.0;
};

/// Finds the time stamps, or the angles of a table over the crank angle, before they were rounded. Rounding explains a
/// grid if each of its values is within half a rounding step of the printed one. Of these grids, the spacing and the
/// start that somebody may have chosen are preferred: a spacing that is a part of `whole` (1/30 s) or a round number
/// (0.0125 s), and a start at a multiple of it. Otherwise, returns the grid with the largest margin to the limits of
/// rounding or, if none is within them, the one that exceeds them least.
///
/// `halfSteps`: half of the rounding step of each printed value. `gridNumbers`: how many spacings each value is after
/// the first one. `whole`: one second or a full turn of the crank, in the unit of the values.
EvenGrid findEvenGrid(const Values &printed, const Values &halfSteps, const std::vector<double> &gridNumbers,
                      double whole);

} // namespace slidercrank
