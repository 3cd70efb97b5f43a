// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The rows of a table whose columns are settled: lines of text → numbers by column, and what was left out.

#include "core/import/plain_number.h"
#include "core/import/reference_data.h"
#include "core/import/rounding.h"
#include "core/import/table_columns.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// The numbers of one line, reused from line to line.
struct Row {
    PlainNumber time;                 ///< in seconds
    std::size_t line = 0;
    std::vector<PlainNumber> numbers; ///< by place in TableLayout::channels, in the author's unit; a gap has no digits
};

/// The columns that the rows fill.
class SeriesBuilder
{
public:
    explicit SeriesBuilder(const TableLayout &layout);

    const std::vector<double> &time() const { return m_data.time; }

    void reserve(std::size_t rows);
    void clear(); ///< without rows again, but with the room for them
    void add(const Row &row);
    void add(const SeriesBuilder &later); ///< the rows that follow
    void countLinesFrom(std::size_t linesBefore);

    /// The data, without the columns that hold no number at all: those count as ignored.
    ReferenceData take(TableLayout &layout, std::vector<SkippedRow> skipped);

private:
    ReferenceData m_data;
    RoundingObserver m_timeObserver;
    std::vector<RoundingObserver> m_observers;
};

/// Some lines of the table, read. They are counted from 1 until it is known how many stand before them.
struct ReadLines {
    explicit ReadLines(const TableLayout &layout)
        : rows(layout)
    {
    }

    void clear(); ///< without lines again, but with the room for them

    SeriesBuilder rows;
    std::vector<SkippedRow> skipped;
    std::optional<ReadError> error; ///< with the first line at fault: what is behind it was not read
    std::size_t count = 0;
    std::size_t firstRow = 0; ///< its line; 0: there is no row
    std::string firstTime;    ///< as printed, shortened
};

/// Into what is empty.
void readLines(std::string_view lines, const TableLayout &layout, ReadLines &into);

/// What a line that does not follow the one before in time is refused with.
ReadError timeFault(std::size_t line, const TableLayout &layout, std::string printed);

/// Lists a row left out; where the list is full, counts it.
void leaveOut(SkippedRow row, std::vector<SkippedRow> &skipped);

} // namespace slidercrank
