// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The smallest parts of a table of text: lines, cells and the numbers in them. All text is UTF-8.

#include "core/import/read_fault.h"
#include "core/import/rounding.h"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

inline bool isBlank(char c)
{
    return c == ' ' || c == '\t';
}

inline bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

inline char lowerCase(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The text without the blanks around it.
std::string_view trimmed(std::string_view text);

bool equalIgnoringCase(std::string_view text, std::string_view lowerCaseText);

/// Removes the first line from `rest` and returns it without its end: LF, CR LF or CR.
std::string_view takeLine(std::string_view &rest);

struct Cell {
    std::string_view text;  ///< without the blanks and quotation marks around it; doubled marks stay doubled
    bool wellFormed = true; ///< false: a quotation mark is not closed, or text follows the closing one
};

/// Removes the first cell from the rest of a line and returns it. Between cells stands the delimiter; where that is a
/// space, any run of blanks. Behind the last cell `rest` has no data.
Cell takeCell(std::string_view &rest, char delimiter);

using Cells = std::vector<std::string_view>;

/// The texts of all cells of a line, without empty ones at the end.
Cells splitCells(std::string_view line, char delimiter);

/// The cells between runs of at least so many blanks outside brackets; what stands in brackets belongs to the name in
/// front of it: "Time (s)   P[X] ( mm )".
Cells splitBetweenBlanks(std::string_view line, std::size_t least);

struct CellNumber {
    double value = std::numeric_limits<double>::quiet_NaN(); ///< NaN: a gap or a fault
    PrintedPlaces places{};
    std::optional<RowFault> fault{};
};

/// An empty cell and "nan" are gaps. The minus may be U+2212. Separators of thousands (the other decimal sign) are
/// accepted where they cannot be mistaken: "1.234,56", "1.234.567", but not "1.234" in a file with decimal commas.
CellNumber parseNumber(std::string_view text, DecimalSign decimalSign);

/// Whether the text has the characters of a number, whatever its decimal sign.
bool looksNumeric(std::string_view text);

/// A cell's number, and the known unit behind it: "0.005 sec". Without one the unit is empty.
struct NumberWithUnit {
    std::string_view number;
    std::string_view unit{};
};

NumberWithUnit splitUnit(std::string_view text);

/// What a message repeats of a cell: its beginning, not cut within a character.
std::string excerpt(std::string_view text);

} // namespace slidercrank
