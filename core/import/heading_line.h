// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Splits a line into cells that may be headings, and compares such lines.

#include "core/import/number_rows.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// The cells of a line that may be the headings.
struct HeadingCandidate {
    Cells cells{};
    char delimiter = ',';
    std::size_t times = 0;      ///< number of cells that name a time
    std::size_t quantities = 0; ///< number of cells that name a quantity
    std::size_t line = 0;       ///< index among the lines of the file

    std::size_t known() const { return times + quantities; }
    bool isComplete() const { return times > 0 && quantities > 0; }
};

/// Counts the cells that name a time and those that name a quantity, which units in brackets do not.
HeadingCandidate countNames(Cells cells, char delimiter);

/// Returns the headings without the cells from one that begins with a comment mark, but "%time" of ROS is a heading.
std::span<const std::string_view> headingsBeforeRemark(const Cells &headings);

/// Returns the cells into which a line can be split, with the numbers of names among them: at each delimiter, at all
/// blanks, at two or more blanks outside brackets, at all blanks outside brackets, and behind all brackets.
std::vector<HeadingCandidate> waysToSplit(std::string_view line);

/// Splits a line into cells that may be headings. The delimiter of the row of numbers is chosen if it makes as many
/// cells, one of them a time; else the one with most known names, and of several the one with as many cells as the row.
/// A comment mark before the headings is removed, unless only the line with the mark can be split. Returns no known
/// names for a row of data and for a line that cannot be the headings.
HeadingCandidate readNames(std::string_view line, const NumberRow &row);

/// Returns the line with most names of times and quantities; nullopt if no line has any. Of lines with as many names,
/// it is the last one that has as many cells as the row, or else the first one. Between blanks, at least half of the
/// words are names, unlike in a remark.
std::optional<HeadingCandidate> findMostNames(const std::vector<HeadingCandidate> &lines, const NumberRow &row);

/// Returns the last line that is no line of units, if it has as many words as the row has numbers; else nullopt.
std::optional<HeadingCandidate> findUnknownHeadings(const std::vector<HeadingCandidate> &lines, const NumberRow &row);

} // namespace slidercrank
