// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the choices of columns that would help to read a file that was refused.

#include "core/import/raw_table.h"

#include <vector>

namespace slidercrank
{

/// Returns the choices with which the file could be read, or at least the error would not occur; empty if no choice
/// helps. A choice states the heading of its column, or a number such as "#3" if the heading is empty, not unique, or
/// contains a quotation mark.
std::vector<ColumnChoice> adviceFor(const ReadError &error, RawTable &table);

} // namespace slidercrank
