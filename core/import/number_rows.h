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

    /// Number of cells of this row, or of the next one if it has more, with empty ones at the end.
    std::size_t sizeWithEmptyCells = 0;
    std::size_t line = 0;    ///< index in the `lines` of findFirstRow(), which contain no blank lines
    std::string_view text{}; ///< text of the line, to which the cells refer

    bool isFound() const { return !cells.empty(); }

    /// Returns whether there are as many `other` cells as in the row, with or without the empty ones at its end.
    bool hasCountOf(const Cells &other) const
    {
        return isFound() && other.size() >= cells.size() && other.size() <= sizeWithEmptyCells;
    }
};

/// Returns whether a text looks like a number, with or without a unit.
bool isNumber(std::string_view cell);

/// Returns whether a cell is a number with either decimal sign and with or without a unit, or a gap such as "-" or
/// "NaN".
bool isNumberOrGap(std::string_view cell);

/// Returns the number of cells of a line, with empty ones at the end.
std::size_t countCells(std::string_view line, char delimiter);

/// Returns the first line whose cells are numbers or gaps, at least two of them numbers; a row without cells if there
/// is none. Spaces are regarded as the delimiter only if no other delimiter makes any line a row.
NumberRow findFirstRow(Lines lines);

/// Returns whether a text of at least ten lines is no table, because no delimiter makes three consecutive rows with the
/// same number of cells, of which at least half (and two) are numbers.
bool isProse(const std::vector<Line> &lines);

/// Returns whether the quantities are the rows of the table: one line begins with the name of the time or the crank
/// angle, another one with that of another quantity, and numbers follow.
bool isTransposed(Lines lines);

} // namespace slidercrank
