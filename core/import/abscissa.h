// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the column of each file that contains the time or the crank angle.

#include "core/import/raw_table.h"

#include <cstddef>
#include <string>

namespace slidercrank
{

/// Returns whether the file has a column of time stamps or crank angles.
bool hasAbscissa(const RawTable &table, std::size_t file);

/// Makes a column the time or the crank angle, and converts it from `unit` to seconds or degrees. If there is such a
/// column already, in another file or for another signal, both must contain the same. Throws ReadError.
void setAbscissa(RawTable &table, RawColumn &column, ColumnRole role, ColumnReason reason, const std::string &unit);

/// Finds the abscissa of each file that has none yet, by the names of the columns or else by their values. Throws
/// ReadError if the files contain different time stamps.
void assignAbscissas(RawTable &table);

} // namespace slidercrank
