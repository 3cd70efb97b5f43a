// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the table in a text: the delimiter, the decimal sign, the lines above the headings, the headings, the units and
// the rows of numbers.

#include "core/import/cells.h"
#include "core/import/heading.h"
#include "core/import/reference_data.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// A line that is not blank.
struct Line {
    std::size_t number = 0; ///< from 1
    std::string_view text;
    std::string_view below; ///< the rest of the text
};

/// One of the files whose columns are side by side in a table.
struct TableFile {
    std::string name{};
    std::string converted{};                   ///< the text if the bytes are not UTF-8
    FileLayout layout{};                       ///< without columns and rows
    std::vector<Heading> headings{};           ///< the unit may also be from a line of units or from the cells
    std::vector<std::string_view> cellUnits{}; ///< by column: the unit after the number in each cell
    std::string_view data{};                   ///< all lines below the headings and units
    std::size_t firstDataLine = 0;
    std::size_t firstColumn = 0; ///< in the table
    std::vector<Line> rows{};    ///< refer to the bytes or to `converted`, like the other views
};

/// Finds the table in a text in UTF-8 without byte order mark, and sets `layout` to `firstDataLine`. Throws ReadError.
void findTable(std::string_view text, TableFile &file);

bool isBlankLine(std::string_view line);

} // namespace slidercrank
