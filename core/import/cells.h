// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lines, cells and numbers in a table of text. All text is UTF-8.

#include "core/import/read_fault.h"
#include "core/import/rounding.h"
#include "core/mechanism/mechanism.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// Returns whether the character is white space. Line ends are only in quoted headings.
inline bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Returns the value of a byte, from 0 to 255.
inline unsigned byteOf(char c)
{
    return static_cast<unsigned char>(c);
}

inline bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Returns the text without leading and trailing blanks.
std::string_view trimmed(std::string_view text);

/// Removes the first cell from the rest of a line and returns it without surrounding blanks and quotation marks.
/// Doubled quotation marks stay doubled. If a quotation mark is not closed, or text follows the closing one, the cell
/// includes them. If the delimiter is a space, any run of blanks separates two cells. After the last cell,
/// `rest.data()` is null.
std::string_view takeCell(std::string_view &rest, char delimiter);

/// The delimiters of cells apart from spaces. LaTeX has "&".
inline constexpr std::string_view kDelimiters = "\t;,|&";

/// All delimiters. Spaces are the last one, because they are within cells, too.
inline constexpr std::string_view kAllDelimiters = "\t;,|& ";

using Cells = std::vector<std::string_view>;

/// Returns the texts of all cells of a line, without the empty ones at the end.
Cells splitCells(std::string_view line, char delimiter);

/// Splits a line behind the brackets at the end of each heading: "Crank angle (deg) Position (mm)" has two cells.
Cells splitBehindBrackets(std::string_view line);

/// Splits a line at runs of at least `least` blanks outside brackets. Text in brackets belongs to the name before it:
/// "Time (s)   P[X] ( mm )" has two cells.
Cells splitAtBlanks(std::string_view line, std::size_t least);

/// Returns the text in brackets that fills a cell; empty if there are none.
std::string_view inBrackets(std::string_view cell);

struct CellNumber {
    double value = kNone; ///< NaN for a gap or a fault
    PrintedPlaces places{};
    std::optional<RowFault> fault{};
    std::string_view unit{}; ///< that the spelling of the number implies: "rad" of "π/6", "deg" of "45°30'"; else empty
};

/// Parses a number. An empty cell, "nan" and "NA" are gaps. Accepts U+2212 and dashes as minus sign, Fortran's exponent
/// ("1.5D+03") and thousands separators: spaces and apostrophes, and the other decimal sign where it is unambiguous
/// ("1.234,56" and "1.234.567", but not "1.234", in a file with decimal commas). "- 1.5" and "(1.5)" are -1.5,
/// "1.5 ± 0.1" is 1.5, ="1.5" of spreadsheets and \num{1.5} of LaTeX, too. "π/6" is a number of radians, and
/// 45°30'15" one of degrees.
CellNumber parseNumber(std::string_view text, DecimalSign decimalSign);

/// Parses the time of a clock, "12:34:56.789" or "05:06.7", with or without a date before it and a time zone after it:
/// the seconds since midnight. Either decimal sign may be before the fractions of a second, whatever the file has.
CellNumber parseClock(std::string_view text);

/// Returns whether the text consists of the characters of a number with either decimal sign.
bool looksNumeric(std::string_view text);

struct NumberWithUnit {
    std::string_view number;
    std::string_view unit{};
};

/// Splits "0.005 sec" into the number and the known unit after it. Without a known unit, all of the text is the number.
NumberWithUnit splitUnit(std::string_view text);

/// Returns the beginning of a cell for a message, never cut within a character.
std::string excerpt(std::string_view text);

} // namespace slidercrank
