// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/raw_table.h"

#include "core/import/file_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr double kUnreadable = std::numeric_limits<double>::infinity();
constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

CellNumber parseCell(const RawColumn &column, std::string_view cell, DecimalSign decimalSign)
{
    const std::string_view unit = column.cellUnit;
    if (!unit.empty() && cell.ends_with(unit)) {
        cell = trimmed(cell.substr(0, cell.size() - unit.size()));
    }
    return parseNumber(cell, decimalSign);
}

/// Calls `visit(column, cell)` for each cell of a row, and returns the cell that makes all of the row unreadable:
/// an additional one, or the last one of a row with fewer than two. Other missing cells at the end are gaps.
template <typename Visit>
std::optional<SkippedRow> visitCells(RawTable &table, const TableFile &file, std::size_t row, const Visit &visit)
{
    const Line &line = file.rows[row];
    std::optional<SkippedRow> fault;
    std::size_t cells = 0;
    for (std::string_view rest = line.text; rest.data() != nullptr; ++cells) {
        const std::string_view cell = takeCell(rest, file.layout.delimiter);
        if (cells < file.width) {
            visit(table.columns[file.firstColumn + cells], cell);
        } else if (!cell.empty() && !fault) {
            fault = {line.number, cells + 1, excerpt(cell), RowFault::TooManyCells};
        }
    }
    return cells < std::min<std::size_t>(file.width, 2) ? SkippedRow{line.number, cells, {}, RowFault::TooFewCells}
                                                        : fault;
}

void readRow(RawTable &table, const TableFile &file, std::size_t row)
{
    const auto read = [&](RawColumn &column, std::string_view cell) {
        const CellNumber number = parseCell(column, cell, file.layout.decimalSign);
        column.values[row] = number.fault ? kUnreadable : number.value;
        if (!std::isnan(number.value)) {
            column.rounding.observe(number.places, number.value);
        }
    };
    if (visitCells(table, file, row, read)) {
        for (std::size_t i = 0; i < file.width; ++i) {
            table.columns[file.firstColumn + i].values[row] = kUnreadable;
        }
    }
}

} // namespace

bool RawColumn::isUnreadable(std::size_t row) const
{
    return isUsed() && (std::isinf(values[row]) || (isAbscissa() && std::isnan(values[row])));
}

void RawColumn::setReason(ColumnReason reason, std::optional<std::size_t> otherColumn)
{
    use.reason = reason;
    use.otherColumn = otherColumn;
}

RawColumn *RawTable::abscissa()
{
    const auto found = std::ranges::find_if(columns, &RawColumn::isAbscissa);
    return found == columns.end() ? nullptr : &*found;
}

ReadError faultIn(const RawTable &table, const RawColumn &column, ReadFault fault)
{
    const TableFile &file = table.fileOf(column);
    return {
        file.layout.headerLine, column.index - file.firstColumn + 1, excerpt(column.use.heading), std::move(fault), {},
        column.use.file};
}

void readTable(const FileBytes &bytes, const std::stop_token &stop, const std::function<void(double part)> &progress,
               RawTable &table)
{
    constexpr std::size_t kReportEvery = 4096; // rows
    TableFile &file = table.files.emplace_back();
    file.name = bytes.name;
    file.firstColumn = table.columns.size();
    std::vector<Line> lines = splitLines(decodeText(bytes.bytes, file.layout, file.converted));
    const std::vector<Heading> headings = takeHeadings(lines, file.layout);
    file.rows = std::move(lines);
    for (const Heading &heading : headings) {
        RawColumn &column = table.columns.emplace_back(RawColumn{heading, table.columns.size()});
        column.use.file = table.files.size() - 1;
        column.values.assign(file.rows.size(), kGap);
    }
    file.width = table.columns.size() - file.firstColumn;
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
        readRow(table, file, row);
        if (row % kReportEvery == 0) {
            progress(static_cast<double>(row) / static_cast<double>(file.rows.size()));
            if (stop.stop_requested()) {
                throw ReadError{.fault = {ReadFault::Kind::Stopped}};
            }
        }
    }
    progress(1.0);
}

SkippedRow findRowFault(RawTable &table, std::size_t row)
{
    for (std::size_t file = 0; file < table.files.size(); ++file) {
        const TableFile &own = table.files[file];
        const Line &line = own.rows[row];
        std::optional<SkippedRow> first;
        const auto check = [&](const RawColumn &column, std::string_view cell) {
            const std::optional<RowFault> fault = parseCell(column, cell, own.layout.decimalSign).fault;
            if (fault && !first && column.isUsed()) {
                first = {line.number, column.index - own.firstColumn + 1, excerpt(cell), *fault};
            }
        };
        const std::optional<SkippedRow> last = visitCells(table, own, row, check);
        if (first || last) {
            SkippedRow fault = first.value_or(last.value_or(SkippedRow()));
            fault.file = file;
            return fault;
        }
    }
    const auto unreadable =
        std::ranges::find_if(table.columns, [row](const RawColumn &column) { return column.isUnreadable(row); });
    const bool isRepeated = unreadable == table.columns.end();
    const RawColumn &column = isRepeated ? *table.abscissa() : *unreadable;
    const TableFile &own = table.fileOf(column);
    const Line &line = own.rows[row];
    const std::size_t i = column.index - own.firstColumn;
    const Cells cells = splitCells(line.text, own.layout.delimiter);
    const RowFault fault = isRepeated                       ? RowFault::RepeatedTime
                           : std::isnan(column.values[row]) ? RowFault::NoTime
                                                            : RowFault::TooLarge; // once converted
    return {line.number, i + 1, i < cells.size() ? excerpt(cells[i]) : "", fault, 1, column.use.file};
}

FileLayout takeLayout(RawTable &table)
{
    constexpr std::size_t kPreviewRows = 6;
    FileLayout layout = table.files.empty() ? FileLayout() : table.files.front().layout;
    for (const TableFile &file : table.files) {
        const std::size_t rows = std::min(file.rows.size(), kPreviewRows);
        layout.rows.resize(std::max(layout.rows.size(), rows));
        for (std::size_t row = 0; row < rows; ++row) {
            layout.rows[row].resize(file.firstColumn);
            std::ranges::transform(splitCells(file.rows[row].text, file.layout.delimiter),
                                   std::back_inserter(layout.rows[row]), excerpt);
        }
        if (table.files.size() > 1) {
            layout.files.push_back(file.name);
        }
    }
    std::ranges::transform(table.columns, std::back_inserter(layout.columns), &RawColumn::use);
    return layout;
}

} // namespace slidercrank
