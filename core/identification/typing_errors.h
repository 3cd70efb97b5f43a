// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Typing errors in tables that a person wrote: single cells that are far from the curve through their neighbours.

#include "core/import/reference_data.h"

#include <cstddef>
#include <optional>

namespace slidercrank
{

/// Returns the row that may contain a typing error: that of the value which is farthest from a smooth curve through its
/// neighbours, compared with the other values of its column. Returns nullopt if no value is much farther than the
/// others and than its rounding, and for tables of more rows than a person types. An angle may jump by whole turns. A row
/// at a corner of a curve may also be returned.
std::optional<std::size_t> findSuspiciousRow(const ReferenceData &data);

/// Returns the table with gaps in all columns of a row.
ReferenceData withoutRow(ReferenceData data, std::size_t row);

} // namespace slidercrank
