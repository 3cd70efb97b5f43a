// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Typing errors in tables that a person wrote: single cells that are far from the curve through their neighbours, or
// from the motion of the mechanism that was fitted to all of them.

#include "core/identification/last_fit.h"

#include "core/import/reference_data.h"

#include <cstddef>
#include <optional>

namespace slidercrank
{

/// Returns the row that may contain a typing error: that of the value whose distance from a smooth curve through its
/// neighbours is largest, compared with the distances of the other values of its column. Returns nullopt if no such
/// distance is much larger than the other ones of its column and than the rounding. An angle may jump by whole turns. A
/// row at a corner of a curve may also be returned.
std::optional<std::size_t> findSuspiciousRow(const ReferenceData &data);

/// Returns the row of the file with the largest residual, compared with the other residuals of its column. (A wrong
/// crank angle leaves the curves of the other columns smooth, but not their residuals.) Returns nullopt if the fit is
/// not finite, if rounding explains all residuals, or if none is much larger than the others of its column.
std::optional<std::size_t> findRowWithLargestResidual(const LastFit &lastFit);

/// The largest number of rows that may be left out because of typing errors: 0 for tables that are too short to show
/// them, or longer than those that a person types.
std::size_t maxTypingErrors(const ReferenceData &data);

/// Returns the table with gaps in all columns of a row.
ReferenceData withoutRow(ReferenceData data, std::size_t row);

} // namespace slidercrank
