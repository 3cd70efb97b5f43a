// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Second stage of reading: from text to a table of numbers, whose columns have no meaning yet.

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

/// A cell that cannot be read.
struct BadCell {
    std::size_t row = 0;
    std::size_t column = 0; ///< from 0, in its file
    std::string text{};
    RowFault fault = RowFault::NotANumber;
    bool spoilsRow = false; ///< whether the row has to be skipped even if the column is ignored
};

/// One of the files whose columns are side by side in the table.
struct TableFile {
    std::size_t firstColumn = 0;
    std::size_t headerLine = 0; ///< 0: none
    std::size_t firstDataLine = 0;
    std::string headerText{};         ///< for messages
    std::vector<std::size_t> lines{}; ///< line number of each row, from 1
    std::vector<BadCell> badCells{};  ///< by row; at most kListedRows + 1 in each column
};

struct RawColumn {
    Heading heading{};
    std::size_t index = 0; ///< in the table
    FileColumn use{};      ///< role and reason are set by assignColumns()
    std::vector<double>
        values{}; ///< gap: NaN, unreadable cell: infinity. In the unit of the file until the role is set
    RoundingObserver rounding{};
    double factor = 1.0; ///< to the default unit

    bool isUndecided() const { return use.role == ColumnRole::Ignored && use.reason == ColumnReason::UnknownName; }
    bool isAbscissa() const { return use.role == ColumnRole::Time || use.role == ColumnRole::CrankAngle; }
    void setReason(ColumnReason reason, std::optional<std::size_t> otherColumn = {});
};

struct RawTable {
    FileLayout layout{}; ///< without the columns
    std::vector<TableFile> files{};
    std::vector<RawColumn> columns{};

    const TableFile &fileOf(const RawColumn &column) const { return files[column.use.file]; }

    /// Returns the column of time stamps or crank angles, or null.
    RawColumn *abscissa();
};

/// Returns an error at the heading of a column.
ReadError faultIn(const RawTable &table, const RawColumn &column, ReadFault fault);

/// Number of skipped rows that are listed one by one.
inline constexpr std::size_t kListedRows = 1000;

/// Appends the columns of a file to the table. `progress` is called regularly with the number of bytes that have been
/// read. Throws ReadError.
void readTable(std::string_view text, const FileBytes &file, const std::stop_token &stop,
               const std::function<void(std::size_t done)> &progress, RawTable &table);

} // namespace slidercrank
