// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Third stage of reading: what each column is. A person's choice decides first, then the name of a channel, then words
// that say body and quantity, and last a quantity of the body that is usually exported, where unit and values do not
// contradict it. The column with the best evidence becomes the channel; between equals a person has to choose.

#include "core/import/raw_table.h"

#include <cstddef>
#include <span>

namespace slidercrank
{

/// Settles the role of every column and converts those that are used to seconds, degrees and the author's units.
/// Throws ReadError where that cannot be done, or where the files are not of one motion as far as their columns tell.
void assignColumns(RawTable &table, std::span<const ColumnChoice> choices);

/// An error in the heading of that column.
ReadError faultIn(const RawTable &table, std::size_t column, ReadFault fault);

} // namespace slidercrank
