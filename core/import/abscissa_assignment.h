// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the column of the time stamps or, instead of it, of the crank angles.

#include "core/import/raw_table.h"

namespace slidercrank
{

/// Makes a column the time or the crank angle. If there is such a column already, in another file or for another
/// signal, both must contain the same. Throws ReadError if they do not, or if the unit is
/// unknown. Converts the values to s or °, and counts times of a clock or since 1970 from the first row.
void setAbscissa(RawTable &table, RawColumn &column, ColumnRole role, ColumnReason reason);

/// Finds the abscissa of each file that has none yet, by the names of the columns or else by their values.
void assignAbscissas(RawTable &table);

} // namespace slidercrank
