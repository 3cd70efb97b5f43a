// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The geometry from those derivatives in the file that show it best.

#include "core/identification/freedoms.h"

namespace slidercrank
{

/// Finds the geometry from the lowest derivatives of R4_x and θ3 in the file (usually their positions), and again from
/// the next higher ones, because a filter or a sensor may have changed the lower ones. Returns the better geometry:
/// over the time, the one with the lower misfit in all of these columns; in a file with θ2, the second one if rounding
/// explains its columns. Difference quotients of exactly explained positions show no better geometry unless it is exact
/// in all columns. If rounding explains the lower derivatives with their usual origins, nothing has changed them,
/// and the second search is omitted; also if rounding explains them with any origins in a file with θ2. If θ3 and
/// R4_x come from two mechanisms, each of which explains one of them exactly and over at least a turn, the geometry is
/// that of R4_x.
/// `searched`: selected rows of `wholeFile`.
ConstrainedFit findBestGeometry(const Observations &wholeFile, const Observations &searched, const Parameters &given);

/// Finds the geometry for which the approximate formula of textbooks explains R4_x (Model::isApproximateFormula).
ConstrainedFit findGeometryOfApproximateFormula(const Observations &wholeFile, const Observations &searched,
                                                const Parameters &given);

/// Finds the geometry from the next higher derivatives alone. Not finite unless the file contains some that are rounded
/// more finely than the lower ones.
ConstrainedFit findGeometryOfHigherDerivatives(const Observations &wholeFile, const Observations &searched,
                                               const Parameters &given);

} // namespace slidercrank
