// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The geometry (the lengths, and the drive as far as the columns show it) from the orders of R4_x and θ3 in the file
// that show it best. The order of a position is 0, that of its n-th derivative n. In all functions, `searched` are
// selected rows of `wholeFile`, `given` supplies what the columns do not determine, and the result is not finite if no
// mechanism can be assembled.

#include "core/identification/freedoms.h"

namespace slidercrank
{

/// Finds the geometry from the lowest orders (usually the positions), and again from the next higher ones, because a
/// filter or a sensor may have changed the lower ones. Returns the better geometry:
///   - Over the time, it is the one with the lower misfit in the columns of both. But if rounding explains the lower
///     orders, and the higher ones are difference quotients, the second one must also explain all columns exactly.
///   - In a file with θ2, it is the second one if rounding explains its columns.
/// Omits the second search if rounding explains the lower orders with their usual origins (in a file with θ2: with any
/// origins), because then nothing has changed them.
///
/// If a search has two columns that come from two mechanisms, each of which explains one column exactly and over at
/// least a turn, the geometry is that of the second column: R4_x, if the columns are θ3 and R4_x.
ConstrainedFit findBestGeometry(const Observations &wholeFile, const Observations &searched, const Parameters &given);

/// Finds the geometry of the lowest orders, and fits it to them again with the approximate formula of textbooks for
/// R4_x (Model::isApproximateFormula).
ConstrainedFit findGeometryOfApproximateFormula(const Observations &wholeFile, const Observations &searched,
                                                const Parameters &given);

/// Finds the geometry from the next higher orders alone. Besides, the result is not finite if there are no columns of
/// these orders, or if they are not at least three times as finely rounded (relative to their ranges) as those of the
/// lowest orders.
ConstrainedFit findGeometryOfHigherDerivatives(const Observations &wholeFile, const Observations &searched,
                                               const Parameters &given);

} // namespace slidercrank
