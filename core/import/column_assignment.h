// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Third stage of reading: what each column is. A person's choice decides first, then the name of a channel, then words
// that say body and quantity, and last a quantity of the body that is usually exported, where unit and values do not
// contradict it. The column with the best evidence becomes the channel; between equals a person has to choose.

#include "core/import/raw_table.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace slidercrank
{

/// The columns of one or several files side by side.
struct JoinedTable {
    std::vector<RawTable> files{};           ///< without headings, columns and roundings, which stand here
    std::vector<std::size_t> firstColumns{}; ///< of each file
    std::vector<Heading> headings{};
    std::vector<std::vector<double>> columns{};
    std::vector<RoundingObserver> roundings{};
    std::vector<double> factors{}; ///< by which the columns that are used were multiplied, to the author's units
    FileLayout layout{};           ///< where the assignment is written
    std::optional<std::size_t> abscissa{};

    /// An error in the heading of that column.
    ReadError faultIn(std::size_t column, ReadFault fault) const;
};

/// Settles the role of every column and converts those that are used to seconds, degrees and the author's units.
/// Returns why that cannot be done, or why the files are not of one motion as far as their columns tell.
std::optional<ReadError> assignColumns(JoinedTable &table, std::span<const ColumnChoice> choices);

/// The factor to the author's unit; 1 without a unit, nothing where the unit does not suit.
std::optional<double> factorTo(Channel channel, const std::string &unit);

} // namespace slidercrank
