// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Second stage of reading: text → table of numbers, before anybody knows what its columns are.

#include "core/import/heading.h"
#include "core/import/reference_data.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// A cell, or the number of cells of a row, that cannot be read.
struct BadCell {
    std::size_t row = 0;
    std::size_t column = 0; ///< from 0, in its file
    std::string text{};
    RowFault fault = RowFault::NotANumber;
    bool spoilsRow = false; ///< whatever its column is used for
};

/// One of the files whose columns stand side by side.
struct TableFile {
    std::size_t firstColumn = 0;
    std::size_t headerLine = 0; ///< 0: none
    std::size_t firstDataLine = 0;
    std::string headerText{};         ///< for messages
    std::vector<std::size_t> lines{}; ///< of each row, from 1
    std::vector<BadCell> badCells{};  ///< by rows; of each column the first kMostSkippedRows
};

struct RawTable {
    FileLayout layout{}; ///< as read, the columns have no role
    std::vector<TableFile> files{};
    std::vector<Heading> headings{};
    std::vector<std::vector<double>> columns{}; ///< in the file's units; NaN: a gap, infinity: cannot be read
    std::vector<RoundingObserver> roundings{};

    // Set by assignColumns().
    std::vector<double> factors{}; ///< by which the columns that are used were multiplied, to the author's units
    std::optional<std::size_t> abscissa{};

    const TableFile &fileOf(std::size_t column) const { return files[layout.columns[column].file]; }
};

/// How many rows that are left out are listed one by one.
inline constexpr std::size_t kMostSkippedRows = 1000;

/// Puts the columns of a file beside those of the files before. `text`: its text. `progress` is called with the bytes
/// of it that are done, now and then. Throws ReadError.
void readTable(std::string_view text, const FileBytes &file, const std::stop_token &stop,
               const std::function<void(std::size_t done)> &progress, RawTable &table);

} // namespace slidercrank
