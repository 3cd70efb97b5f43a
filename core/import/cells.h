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

/// Returns whether the character is white space. Line ends belong to it, because quoted headings may contain them.
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

/// The characters that may separate cells, without the space. Tables in LaTeX have "&".
inline constexpr std::string_view kDelimiters = "\t;,|&";

/// The characters that may separate cells, in the order in which they are tried. The space is the last one, because it
/// also occurs within cells.
inline constexpr std::string_view kAllDelimiters = "\t;,|& ";

using Cells = std::vector<std::string_view>;

/// Returns the texts of all cells of a line, without the empty ones at the end.
Cells splitCells(std::string_view line, char delimiter);

/// Splits a line behind each closing bracket that a blank follows: "Crank angle (deg) Position (mm)" has two cells.
Cells splitBehindBrackets(std::string_view line);

/// Splits a line at runs of at least `minBlanks` blanks outside brackets. Text in brackets belongs to the name before
/// it: "Time (s)   P[X] ( mm )" has two cells.
Cells splitAtBlanks(std::string_view line, std::size_t minBlanks);

/// Returns the text between the round or square brackets that enclose a cell; empty if none do.
std::string_view textInBrackets(std::string_view cell);

struct CellNumber {
    double value = kNone; ///< NaN for a gap or a fault
    PrintedPlaces places{};
    std::optional<RowFault> fault{};
    std::string_view unit{}; ///< unit that the spelling implies: "rad" for "π/6", "deg" for "45°30'"; otherwise empty
};

/// Parses a number. An empty cell, "nan" and "NA" are gaps. The following are accepted:
///
/// - U+2212 and dashes as minus sign, a blank behind the sign ("- 1.5"), and brackets instead of it ("(1.5)"),
/// - Fortran's exponent: "1.5D+03",
/// - thousands separators: spaces and apostrophes, and the other decimal sign where it is unambiguous ("1.234,56" and
///   "1.234.567", but not "1.234", in a file with decimal commas),
/// - an uncertainty behind the number, "1.5 ± 0.1", and the marks of spreadsheets, ="1.5", and LaTeX, \num{1.5},
/// - "π/6", a number of radians, and 45°30'15", one of degrees.
///
/// A number may have the fault TooLarge. Other texts have the fault NotANumber, or PointForComma or CommaForPoint if
/// the other decimal sign would suit.
CellNumber parseNumber(std::string_view text, DecimalSign decimalSign);

/// Parses the time of a clock, "12:34:56.789" or "05:06.7", with or without a date before it and a time zone after it.
/// The value is the number of seconds since midnight. The decimal sign may be a point or a comma, regardless of that of
/// the file. A time with a single colon and without a fraction, as in "12:34", has the fault NotANumber.
CellNumber parseClock(std::string_view text);

/// Returns whether a text looks like a number with either decimal sign: it consists of digits, signs, separators and
/// the letter e, or is a multiple of π, or an angle in degrees and minutes.
bool looksNumeric(std::string_view text);

struct NumberWithUnit {
    std::string_view number;
    std::string_view unit{};
};

/// Splits "0.005 sec" into the number and the known unit after it. Without a known unit, all of the text is the number.
NumberWithUnit splitUnit(std::string_view text);

/// Returns a text for a message. Of a long one it is the beginning, cut between two characters, with "…".
std::string excerpt(std::string_view text);

} // namespace slidercrank
