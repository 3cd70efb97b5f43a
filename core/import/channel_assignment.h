// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the columns that are channels. The column with the best evidence becomes the channel; between equal ones a
// person has to choose.

#include "core/import/raw_table.h"

namespace slidercrank
{

/// Returns the error that two columns are the same channel. The error is at the second column or, if the columns are in
/// different files, names the file of the first one.
ReadError sameChannelError(const RawTable &table, const RawColumn &first, const RawColumn &second);

/// Uses the column with the best evidence as the channel, if there is only one, and sets the reason of ignored columns.
/// Requires that the abscissa is known. Throws ReadError if two columns have the exact name of a channel or were chosen
/// as the same channel, or if the unit of such a column does not suit the channel.
void assignChannels(RawTable &table);

} // namespace slidercrank
