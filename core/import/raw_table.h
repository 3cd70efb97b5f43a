// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Second stage of reading: from text to a table of numbers, whose columns are not used for anything yet.

#include "core/import/reference_data.h"
#include "core/import/table_form.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// A column of numbers. The first members say how the file names it and how it is used.
struct RawColumn {
    FileColumn use{};
    std::string name{};
    CellForm cells{};
    NameMeaning meaning{};

    std::size_t index = 0;                ///< in RawTable::columns
    std::optional<ColumnChoice> choice{}; ///< of a person

    /// One value per row: NaN for a gap, infinity for an unreadable cell. In the unit of the file until convert().
    std::vector<double> values{};
    RoundingObserver rounding{};
    double factor = 1.0; ///< from the unit of the file to the default unit
    double origin = 0.0; ///< subtracted from the values: in s for time stamps, in ° for an angle at B

    bool isUsed() const { return use.role != ColumnRole::Ignored; }
    /// Returns whether neither the heading nor a person has decided what the column is used for.
    bool isUndecided() const { return !isUsed() && use.reason == ColumnReason::UnknownName; }
    bool isAbscissa() const { return use.role == ColumnRole::Time || use.role == ColumnRole::CrankAngle; }

    /// Returns the unit that the column would have in that role: the chosen one, or that of the file, or else the
    /// default unit. Returns nullopt if the unit does not suit the role.
    std::optional<Unit> unitAs(ColumnRole role, Channel channel = {}) const
    {
        return parseColumnUnit(choice && !choice->unit.empty() ? choice->unit : use.unit, role, channel);
    }

    /// Returns the values without gaps and unreadable cells.
    std::vector<double> finiteValues() const;

    /// Returns whether the row has to be skipped because this column is used and its cell is unreadable, or is a gap in
    /// the abscissa.
    bool isUnreadable(std::size_t row) const;
};

/// One of the files whose columns are side by side in a table.
struct TableFile {
    std::string name{};
    std::string converted{};     ///< the text if it had to be converted: see decodeText()
    FileLayout layout{};         ///< without columns and rows
    std::vector<Line> rows{};    ///< refer to the bytes or to `converted`
    std::size_t firstColumn = 0; ///< in the table
    std::size_t width = 0;       ///< number of columns
    std::size_t fewestCells = 0; ///< a row with fewer cells cannot be read; with fewer than `width`, it ends with gaps
    bool hasAbscissa = false;    ///< whether one of its columns contains the time stamps or crank angles
};

struct RawTable {
    std::deque<TableFile> files{}; ///< a deque does not move its elements, to which their rows refer
    std::vector<RawColumn> columns{};

    const TableFile &fileOf(const RawColumn &column) const { return files[column.use.file]; }
    std::span<RawColumn> columnsOf(const TableFile &file)
    {
        return std::span(columns).subspan(file.firstColumn, file.width);
    }

    /// Returns the column of time stamps or crank angles, or null.
    RawColumn *abscissa();
};

/// Converts the values of a column from `unit` to the default unit.
void convert(RawColumn &column, const Unit &unit);

/// Returns whether a person chose the meaning of the column.
inline bool isChosen(const RawColumn &column)
{
    return column.meaning.kind == NameMeaning::Kind::Chosen;
}

/// Removes the columns that meet the condition, and sets the reason why they are ignored.
template <typename Condition>
void removeColumns(std::vector<RawColumn *> &columns, ColumnReason reason, const Condition &condition)
{
    std::erase_if(columns, [&](RawColumn *column) {
        const bool isRemoved = condition(*column);
        column->use.reason = isRemoved ? reason : column->use.reason;
        return isRemoved;
    });
}

/// Returns an error at the heading of a column, with `fault` as its reason.
ReadError errorAtHeading(const RawTable &table, const RawColumn &column, ReadFault fault);

/// Appends the columns of a file to the table. `progress` is called regularly with the fraction that was read; see
/// ReadOptions::progress for its result. Throws ReadError.
void readTable(const FileBytes &bytes, const std::function<bool(double fraction)> &progress, RawTable &table);

/// Returns why a row is skipped: the fault of the first used column that is unreadable there, or else that the time is
/// repeated.
SkippedRow findRowFault(RawTable &table, std::size_t row);

/// Returns how the files are written, their first rows, and how their columns are used.
FileLayout describeLayout(const RawTable &table);

} // namespace slidercrank
