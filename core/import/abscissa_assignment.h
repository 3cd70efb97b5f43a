// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the abscissa: the column of the time stamps or, instead of it, the column of the crank angles.

#include "core/import/raw_table.h"

namespace slidercrank
{

/// Uses a column as the time or the crank angle, with `reason`, and converts its values to s or °. Times of day and
/// times since a date are counted from the first one. If the table already has an abscissa, of another file or another
/// signal, the column is ignored if both contain the same values. Throws ReadError if they do not, if the unit is
/// unknown, or if times without a unit are too large for seconds.
void setAbscissa(RawTable &table, RawColumn &column, ColumnRole role, ColumnReason reason);

/// Finds the abscissa of each file that has none yet, by the names of the columns or else by their values. Ignores
/// further columns whose names denote a time.
void assignAbscissas(RawTable &table);

} // namespace slidercrank
