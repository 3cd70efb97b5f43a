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

CellNumber parseCell(const TableFile &file, std::size_t column, std::string_view cell)
{
    const std::string_view unit = file.cellUnits[column];
    if (!unit.empty() && cell.ends_with(unit)) {
        cell = trimmed(cell.substr(0, cell.size() - unit.size()));
    }
    return parseNumber(cell, file.layout.decimalSign);
}

/// Calls `visit(column, cell)` for each cell of a row, and returns the cell that makes all of the row unreadable:
/// an additional one, or the last one of a row with fewer than two. Other missing cells at the end are gaps.
template <typename Visit>
std::optional<SkippedRow> visitCells(const TableFile &file, const Line &row, const Visit &visit)
{
    const std::size_t width = file.headings.size();
    std::optional<SkippedRow> fault;
    std::size_t cells = 0;
    for (std::string_view rest = row.text; rest.data() != nullptr; ++cells) {
        const std::string_view cell = takeCell(rest, file.layout.delimiter);
        if (cells < width) {
            visit(cells, cell);
        } else if (!cell.empty() && !fault) {
            fault = {row.number, cells + 1, excerpt(cell), RowFault::TooManyCells};
        }
    }
    return cells < std::min<std::size_t>(width, 2) ? SkippedRow{row.number, cells, {}, RowFault::TooFewCells} : fault;
}

void readRow(const TableFile &file, const Line &row, std::span<RawColumn> columns)
{
    const std::size_t before = columns[0].values.size();
    const auto read = [&](std::size_t i, std::string_view cell) {
        const CellNumber number = parseCell(file, i, cell);
        columns[i].values.push_back(number.fault ? kUnreadable : number.value);
        if (!std::isnan(number.value)) {
            columns[i].rounding.observe(number.places, number.value);
        }
    };
    const bool isUnreadable = visitCells(file, row, read).has_value();
    for (RawColumn &column : columns) {
        column.values.resize(before + 1, kGap);
        column.values.back() = isUnreadable ? kUnreadable : column.values.back();
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
    const std::string_view text = decodeText(bytes.bytes, file.layout, file.converted);
    findTable(text, file);
    for (const Heading &heading : file.headings) {
        table.columns.push_back({heading, table.columns.size()});
        table.columns.back().use.file = table.files.size() - 1;
    }
    std::size_t number = file.firstDataLine;
    for (std::string_view rest = file.data; !rest.empty(); ++number) {
        if (number % kReportEvery == 0) {
            progress(1.0 - static_cast<double>(rest.size()) / static_cast<double>(text.size()));
            if (stop.stop_requested()) {
                throw ReadError{.fault = {ReadFault::Kind::Stopped}};
            }
        }
        if (const std::string_view line = takeLine(rest); !isBlankLine(line)) {
            file.rows.push_back({number, line, rest});
            readRow(file, file.rows.back(), std::span(table.columns).subspan(file.firstColumn));
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
        const auto check = [&](std::size_t i, std::string_view cell) {
            const std::optional<RowFault> fault = parseCell(own, i, cell).fault;
            if (fault && !first && table.columns[own.firstColumn + i].isUsed()) {
                first = {line.number, i + 1, excerpt(cell), *fault};
            }
        };
        const std::optional<SkippedRow> last = visitCells(own, line, check);
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
