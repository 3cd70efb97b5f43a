// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Splits a text into lines, without what is no part of the table.

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// A line that is not blank.
struct Line {
    std::size_t number = 0; ///< from 1
    std::string_view text;
};

using Lines = std::span<const Line>;

inline constexpr std::size_t kExaminedLines = 200; ///< number of lines that are examined to find the form of the table

/// Returns the lines that are examined for the form of the table.
inline Lines firstLines(Lines lines)
{
    return lines.first(std::min(lines.size(), kExaminedLines));
}

/// Splits a text at LF, CR LF and CR; a quoted heading may contain line ends. Leaves out blank lines, lines that only
/// separate rows, the preamble of LabVIEW, remarks behind the numbers, and what surrounds a row in Markdown, LaTeX, the
/// source of a program or a serial monitor. Throws ReadError if one of the first lines is too long, or is the common
/// factor of the numbers below: "1.0e+03 *".
std::vector<Line> splitLines(std::string_view text);

/// Returns whether a line begins with a number, so that it is a row of data. "1. Time (s)" is a heading.
bool isData(std::string_view line);

/// Returns whether a line is a remark: "# start", "// start", "/* start */", "-- start", "% start" or "! start".
bool isRemark(std::string_view line);

/// Returns a line without the comment mark that some programs write before the headings.
std::string_view withoutCommentMark(std::string_view line);

} // namespace slidercrank
