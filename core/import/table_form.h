// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the table in a text: the delimiter, the decimal sign, the lines above the headings, the headings, the units and
// the rows of numbers.

#include "core/import/cells.h"
#include "core/import/heading.h"
#include "core/import/lines.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// Returns whether a text of at least ten lines has no rows of numbers, so that it is no table.
bool isProse(const std::vector<Line> &lines);

/// Returns the unit in a cell below the headings, if the cell contains nothing else ("mm", "(mm)") or Simulink wrote it
/// ("Type: double Unit: rad"). Otherwise empty.
std::string_view unitIn(std::string_view cell);

/// Finds the table in the lines of a file, and removes those above the first row of numbers. Returns the headings,
/// whose units may also be from a line of units or from the cells, and describes the rest in `layout`. Throws
/// ReadError.
std::vector<Heading> takeHeadings(std::vector<Line> &lines, FileLayout &layout);

} // namespace slidercrank
