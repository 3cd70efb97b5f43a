// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where the table stands in a text: preamble, header, line of units, data; what separates the cells; how decimals are
// written.

#include "core/import/cell_scanner.h"
#include "core/import/file_layout.h"
#include "core/import/heading.h"
#include "core/import/reference_data.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace slidercrank
{

struct Table {
    FileLayout layout;                       ///< the columns have their headings and units, no role yet
    std::vector<Heading> headings;           ///< one a column; the unit also from the line of units, or from the cells
    std::vector<std::string_view> cellUnits; ///< by column: that stands behind the number in every cell
    std::string headerText;                  ///< for messages
    std::string_view data;                   ///< everything below header and units
    std::size_t firstDataLine = 0;
};

/// `text`: in UTF-8, without byte order mark; the table refers to it.
std::variant<Table, ReadError> findTable(std::string_view text);

/// At the first line of the data.
CellScanner rowsOf(const Table &table);

/// What a message repeats of a cell: its beginning, not cut within a character.
std::string excerpt(std::string_view text);

} // namespace slidercrank
