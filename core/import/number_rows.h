// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Recognizes the rows of numbers among the lines of a file.

#include "core/import/cells.h"
#include "core/import/lines.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// A row of numbers.
struct NumberRow {
    Cells cells{}; ///< without empty ones at the end
    char delimiter = ',';
    std::size_t sizeWithEmptyCells = 0; ///< number of cells of this row, or of the next one if it has more, with empty
                                        ///< ones at the end
    std::size_t line = 0;               ///< index among the lines of the file
    std::string_view text{};            ///< of the line, which contains the cells

    bool isFound() const { return !cells.empty(); }

    /// Returns whether there are as many cells as in the row, with or without the empty ones at its end.
    bool hasCountOf(const Cells &other) const
    {
        return isFound() && other.size() >= cells.size() && other.size() <= sizeWithEmptyCells;
    }
};

/// Returns whether the text is a number with or without a unit.
bool isNumber(std::string_view cell);

/// Returns whether a cell is a number, or a gap such as "-" or "NaN".
bool isNumberOrGap(std::string_view cell);

/// Returns the number of cells of a line, with empty ones at the end.
std::size_t countCells(std::string_view line, char delimiter);

/// Returns the first line whose cells are numbers or gaps, at least two of them numbers; a row without cells if there
/// is none. Spaces count as the delimiter only if no other delimiter makes any line a row.
NumberRow findFirstRow(Lines lines);

/// Returns whether a text of at least ten lines has no rows of numbers, so that it is no table.
bool isProse(const std::vector<Line> &lines);

/// Returns whether the quantities are the rows of the table: one line begins with the name of the time or the crank
/// angle, another one with that of another quantity, and numbers follow.
bool isTransposed(Lines lines);

} // namespace slidercrank
