// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the table in a text: the delimiter, the decimal sign, the lines above the headings, the headings, the units and
// the rows of numbers.

#include "core/import/heading.h"
#include "core/import/lines.h"

#include <vector>

namespace slidercrank
{

/// Finds the table in the lines of a file, and removes the lines above the first row of numbers. Returns the headings
/// with their units, which may also be in a line of units or in the cells, and sets the delimiter, the decimal sign and
/// the header line in `layout`. Throws ReadError.
std::vector<Heading> takeHeadings(std::vector<Line> &lines, FileLayout &layout);

} // namespace slidercrank
