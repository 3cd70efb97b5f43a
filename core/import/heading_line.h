// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Splits lines into cells that may be headings, and finds the line that contains the headings.

#include "core/import/number_rows.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// A line that may contain the headings, split into cells.
struct HeadingCandidate {
    Cells cells{};
    char delimiter = ',';
    std::size_t times = 0;      ///< number of cells that name a time
    std::size_t quantities = 0; ///< number of cells that name a quantity
    std::size_t line = 0;       ///< index among the lines that are not blank

    std::size_t known() const { return times + quantities; }
    bool isComplete() const { return times > 0 && quantities > 0; }
};

/// Returns the cells with the numbers of those that name a time and those that name a quantity, without unknown words.
/// Numbers and units in brackets name neither.
HeadingCandidate countNames(Cells cells, char delimiter);

/// Returns the cells before a remark. A remark begins with "%" or "#", has no meaning (unlike "%time" of ROS), and is
/// not the first cell.
std::span<const std::string_view> headingsBeforeRemark(const Cells &headings);

/// Splits a line in each possible way, and counts the names among its cells: at each delimiter, at all blanks, at two
/// or more blanks outside brackets, at all blanks outside brackets, and behind all brackets.
std::vector<HeadingCandidate> waysToSplit(std::string_view line);

/// Splits a line into cells that may be the headings of `row`. Of several ways to split it, one is preferred that has,
/// in this order:
///
/// 1. as many cells as the row, between the same delimiters, which are not blanks,
/// 2. more known names,
/// 3. as many cells as the row,
/// 4. more cells.
///
/// A comment mark before the headings is removed, unless only the line with the mark can be split. If the line is a row
/// of data or cannot be the headings, returns its words if blanks separate the numbers, and otherwise no cells.
HeadingCandidate readNames(std::string_view line, const NumberRow &row);

/// Returns the line with the most names of times and quantities; nullopt if no line has any. Among lines with equally
/// many, it is the last one that has as many cells as the row and is no line of units, or else the first one. Lines
/// that are split at blanks are ignored as remarks if fewer than half of their words are names.
std::optional<HeadingCandidate> findLineWithMostNames(const std::vector<HeadingCandidate> &lines, const NumberRow &row);

/// Returns the last line that is no line of units; nullopt if it contains numbers or does not have as many cells as the
/// row.
std::optional<HeadingCandidate> findUnknownHeadings(const std::vector<HeadingCandidate> &lines, const NumberRow &row);

} // namespace slidercrank
