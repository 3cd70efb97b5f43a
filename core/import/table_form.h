// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the table stands in a text, and how it is written: lines above the names, names, units, rows of numbers; what
// separates the cells; how decimals are written.

#include "core/import/heading.h"
#include "core/import/reference_data.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

struct TableForm {
    FileLayout layout{};                       ///< the columns have their headings and units, no role yet
    std::vector<Heading> headings{};           ///< by column; the unit also from the line of units, or from the cells
    std::vector<std::string_view> cellUnits{}; ///< by column: behind the number in every cell
    std::size_t fewestCells = 0;               ///< that a row needs: headings at the end may stand above nothing
    std::string headerText{};                  ///< for messages
    std::string_view data{};                   ///< all lines below names and units
    std::size_t firstDataLine = 0;
};

/// `text`: in UTF-8, without byte order mark; the form refers to it. Throws ReadError.
TableForm findTable(std::string_view text);

bool isBlankLine(std::string_view line);

} // namespace slidercrank
