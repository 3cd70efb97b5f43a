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

struct TableForm {
    FileLayout layout{};             ///< without columns and rows
    std::vector<Heading> headings{}; ///< by column; the unit may also be from a line of units or from the cells
    std::vector<std::string_view> cellUnits{}; ///< by column: the unit after the number in each cell
    std::string_view data{};                   ///< all lines below the headings and units
    std::size_t firstDataLine = 0;
};

/// Requires a text in UTF-8 without byte order mark, to which the result refers. Throws ReadError.
TableForm findTable(std::string_view text);

bool isBlankLine(std::string_view line);

} // namespace slidercrank
