// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Several files of one motion, a plot each, as programs write them that export one plot at a time: read as one table,
// whose columns are those of all of them, one file after the other.
//
// Each file is read as it would be by itself. Their instants (or the crank's angles in their place) have to be the same
// as far as they are printed; nothing is interpolated. What a row left out takes from one file is left out of all, as
// it would be in one table.

#include "core/import/reference_data.h"

#include <span>
#include <stop_token>
#include <variant>

namespace slidercrank
{

/// A channel comes from one file only. `options`: columns count on from file to file; what is chosen as the time, or
/// the angle, of the first file holds for a column of that heading in the others, too. An error has the columns of all
/// files. One file alone is read as it is.
std::variant<ReferenceData, ReadError> readJoined(std::span<const ByteSource> files, std::stop_token stop = {},
                                                  const ReadOptions &options = {});

} // namespace slidercrank
