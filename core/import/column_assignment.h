// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Third stage of reading: the meaning of each column. The choices of a person come first, then names of channels, then
// words for body and quantity, and last a quantity of an unnamed body, which is taken for the one that is usually
// exported.

#include "core/import/raw_table.h"

#include <span>

namespace slidercrank
{

/// Sets the role of each column and converts the used ones to seconds, degrees and the default units. Throws ReadError
/// if that is impossible, or if the columns show that the files are not of one motion.
void assignColumns(RawTable &table, std::span<const ColumnChoice> choices);

} // namespace slidercrank
