// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mechanism that explains a few columns best, whatever their unit, sign and origin are.

#include "core/identification/fit.h"

#include <cstddef>
#include <vector>

namespace slidercrank
{

/// Columns that show the shape of the mechanism: for each of θ3 and R4_x, in this order, the column of the lowest order
/// that changes (positions have the order 0). If the file has none of them, the same for the centres of the links. In a
/// file with the angle of the crank, derivatives are left out if there is a position, because they depend on the
/// unknown speed.
Indices shapeColumns(const Observations &observations);

/// For each of θ3 and R4_x, in this order, the column of the second lowest order that changes.
Indices higherShapeColumns(const Observations &observations);

/// Whether the columns determine lengths, and not only ratios of lengths or their products with powers of ω2.
bool areLengthsDetermined(const Observations &observations, const Indices &columns);

/// Fits a mechanism of the open assembly to `columns` of at most some hundred rows. The crank turns counter-clockwise
/// with the time, or with the angle in the file. Lengths may have any scale and either sign; θ3 may be counted in
/// either sense, in degrees or radians; the angle in the file may be in degrees or radians and have any origin. First,
/// R4_x has its usual origin, and that of θ3 is a multiple of half a turn. Only if rounding does not explain the
/// residuals then, both may have any origin, and the fit with the lower misfit is returned. What the columns do not
/// determine is that of `given`. `speeds`: candidates of ω2, for a file without the angle of the crank. The fit is not
/// finite if no mechanism can be assembled.
Fit findGeometry(const Observations &observations, const Indices &columns, const std::vector<double> &speeds,
                 const Parameters &given);

/// Fits only the origins of the positions among `columns` again, so that a geometry explains `columns` as well as it
/// can. Columns that it does not use get usualFactor(). Not finite if the geometry is not finite.
Fit fitWithFreeOrigins(const Observations &observations, const Fit &geometry, const Indices &columns);

} // namespace slidercrank
