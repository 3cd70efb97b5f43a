// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables without a line of headings, whose cells contain them as labels, as the serial plotter of Arduino writes them:
//
//     t:0.1,angle:12.5          x = 85 mm, y = 3 mm

#include "core/import/heading.h"
#include "core/import/lines.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace slidercrank
{

/// The headings of a table, and where they are.
struct TableTop {
    std::vector<Heading> headings{};
    std::size_t headerLine = 0; ///< number of the line of the headings; 0: none, the file begins with numbers
    std::size_t firstRow = 0;   ///< index of the first row of numbers among the lines
    char delimiter = ',';
};

/// Finds the first line whose cells have the same labels before their numbers as those of the next line. Returns
/// headings with these labels and the units of the cells; a cell that is only a label has an empty heading. Returns
/// nullopt if there is no such line.
std::optional<TableTop> readLabelledRows(Lines lines);

} // namespace slidercrank
