// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Typing errors in tables that a person wrote: single cells that are far from the curve through their neighbours.

#include "core/import/reference_data.h"

#include <cstddef>
#include <vector>

namespace slidercrank
{

/// Returns the rows that may contain a typing error: for each column, the row whose value is farthest from a smooth
/// curve through its neighbours, if it is much farther than those of the other rows. None for tables of more rows than
/// a person types. A curve with a corner, such as an angle that jumps by a turn, may also be returned.
std::vector<std::size_t> findSuspiciousRows(const ReferenceData &data);

/// Returns the table with gaps in all columns of a row.
ReferenceData withoutRow(ReferenceData data, std::size_t row);

} // namespace slidercrank
