// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Second stage of reading: text → table of numbers, before anybody knows what its columns are.

#include "core/import/heading.h"
#include "core/import/reference_data.h"

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace slidercrank
{

/// A cell, or the number of cells of a row, that cannot be read.
struct BadCell {
    std::size_t row = 0;
    std::size_t column = 0; ///< from 0
    std::string text{};
    RowFault fault = RowFault::NotANumber;
    bool spoilsRow = false; ///< whatever its column is used for
};

struct RawTable {
    FileLayout layout{}; ///< the columns have their headings and units, no role yet
    std::vector<Heading> headings{};
    std::string headerText{}; ///< for messages
    std::size_t firstDataLine = 0;

    std::vector<std::vector<double>> columns{}; ///< in the file's units; NaN: a gap, infinity: cannot be read
    std::vector<RoundingObserver> roundings{};  ///< by column
    std::vector<std::size_t> lines{};           ///< of each row, from 1
    std::vector<BadCell> badCells{};            ///< by rows; of each column the first kMostSkippedRows
};

/// How many rows that are left out are listed one by one.
inline constexpr std::size_t kMostSkippedRows = 1000;

/// `progress` is called with the bytes of `text` done now and then; it may be empty.
std::variant<RawTable, ReadError> readTable(std::string_view text, const std::stop_token &stop,
                                            const std::function<void(std::size_t done)> &progress);

} // namespace slidercrank
