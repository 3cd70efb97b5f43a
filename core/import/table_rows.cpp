// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/table_rows.h"

#include "core/import/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

/// How many rows left out are listed one by one; the last entry then counts the others.
constexpr std::size_t kMostSkippedRows = 1000;

/// The cell for which a line holds no row; without a fault, the line is blank.
struct BadCell {
    std::size_t column = 0; ///< from 1
    std::string_view text{};
    std::optional<RowFault> fault{};
};

/// The short way through most lines: as many cells as columns, plain numbers in all that count. Where the line is
/// another, the scanner is left at its beginning.
bool readPlainRow(CellScanner &scanner, const TableLayout &layout, Row &row)
{
    const char *const begin = scanner.position();
    for (const ReadColumn &column : layout.columns) {
        bool plain = scanner.hasCell();
        switch (column.role) {
        case ColumnRole::Ignored: plain = plain && scanner.skipPlainCell(); break;
        case ColumnRole::CrankAngle: // ReadColumn calls it Time
        case ColumnRole::Time: plain = plain && scanner.plainNumber(row.time); break;
        case ColumnRole::Channel:
            plain = plain && scanner.plainNumber(row.numbers[column.series]);
            row.numbers[column.series].value *= column.factor;
            break;
        }
        if (!plain) {
            scanner.backTo(begin);
            return false;
        }
    }
    if (scanner.hasCell() || !scanner.atLineEnd()) {
        scanner.backTo(begin);
        return false;
    }
    row.time.value /= layout.columns[layout.timeColumn].factor;
    scanner.nextLine();
    return true;
}

/// Reads any line into `row`; the scanner moves to the next.
std::optional<BadCell> readRow(CellScanner &scanner, const TableLayout &layout, Row &row)
{
    std::optional<BadCell> bad;
    const auto blame = [&bad](std::size_t cell, std::string_view text, RowFault fault) {
        if (!bad) {
            bad = BadCell{cell + 1, text, fault};
        }
    };
    bool blank = true;
    std::size_t cellCount = 0;
    for (; scanner.hasCell(); ++cellCount) {
        const bool named = cellCount < layout.columns.size();
        const ReadColumn column = named ? layout.columns[cellCount] : ReadColumn();
        const Cell cell = scanner.cell();
        CellNumber number;
        if (!cell.wellFormed) {
            number.fault = RowFault::OpenQuotation;
        } else if (column.role != ColumnRole::Ignored) {
            number = readNumber(withoutUnit(cell.text, column.unit), layout.table.layout.decimalSign);
        } else if (!named && !cell.text.empty()) {
            number.fault = RowFault::TooManyCells;
        }
        blank = blank && cell.text.empty();
        switch (column.role) {
        case ColumnRole::Ignored: break;
        case ColumnRole::CrankAngle:
        case ColumnRole::Time:
            row.time = {number.value / column.factor, placesOf(number.digits), number.digits};
            if (!number.fault && std::isnan(row.time.value)) {
                number.fault = RowFault::NoTime;
            }
            break;
        case ColumnRole::Channel: {
            const double value = number.value * column.factor;
            if (std::isinf(value)) {
                number.fault = RowFault::TooLarge;
            }
            row.numbers[column.series] = {value, placesOf(number.digits), number.digits};
            break;
        }
        }
        if (number.fault) {
            blame(cellCount, cell.text, *number.fault);
        }
    }
    scanner.nextLine();
    if (blank) {
        return BadCell{};
    }
    if (cellCount < layout.columns.size()) {
        blame(cellCount - 1, {}, RowFault::TooFewCells);
    }
    return bad;
}

bool isEmpty(const ReferenceSeries &series)
{
    return std::all_of(series.values.begin(), series.values.end(), [](double value) { return std::isnan(value); });
}

} // namespace

/// Lists a row left out; where the list is full, counts it.
void leaveOut(SkippedRow row, std::vector<SkippedRow> &skipped)
{
    if (skipped.size() > kMostSkippedRows) {
        skipped.back().rows += row.rows;
    } else if (skipped.size() == kMostSkippedRows) {
        skipped.push_back({row.line, 0, {}, RowFault::NotListed, row.rows});
    } else {
        skipped.push_back(std::move(row));
    }
}

SeriesBuilder::SeriesBuilder(const TableLayout &layout)
    : m_observers(layout.channels.size())
{
    for (const Channel channel : layout.channels) {
        m_data.series.push_back({channel, {}, {}});
    }
}

void SeriesBuilder::reserve(std::size_t rows)
{
    m_data.time.reserve(rows);
    m_data.lines.reserve(rows);
    for (ReferenceSeries &series : m_data.series) {
        series.values.reserve(rows);
    }
}

void SeriesBuilder::clear()
{
    m_data.time.clear();
    m_data.lines.clear();
    for (ReferenceSeries &series : m_data.series) {
        series.values.clear();
    }
    m_timeObserver = RoundingObserver();
    std::fill(m_observers.begin(), m_observers.end(), RoundingObserver());
}

void SeriesBuilder::add(const Row &row)
{
    m_data.time.push_back(row.time.value);
    m_data.lines.push_back(row.line);
    m_timeObserver.observe(row.time.places, row.time.digits);
    for (std::size_t i = 0; i < row.numbers.size(); ++i) {
        const PlainNumber &number = row.numbers[i];
        m_data.series[i].values.push_back(number.value);
        if (!number.digits.empty()) {
            m_observers[i].observe(number.places, number.digits);
        }
    }
}

void SeriesBuilder::add(const SeriesBuilder &later)
{
    const auto append = [](std::vector<double> &values, const std::vector<double> &more) {
        values.insert(values.end(), more.begin(), more.end());
    };
    append(m_data.time, later.m_data.time);
    m_data.lines.insert(m_data.lines.end(), later.m_data.lines.begin(), later.m_data.lines.end());
    m_timeObserver.add(later.m_timeObserver);
    for (std::size_t i = 0; i < m_observers.size(); ++i) {
        append(m_data.series[i].values, later.m_data.series[i].values);
        m_observers[i].add(later.m_observers[i]);
    }
}

void SeriesBuilder::countLinesFrom(std::size_t linesBefore)
{
    for (std::size_t &line : m_data.lines) {
        line += linesBefore;
    }
}

ReferenceData SeriesBuilder::take(TableLayout &layout, std::vector<SkippedRow> skipped)
{
    m_data.skipped = std::move(skipped);
    m_data.layout = std::move(layout.table.layout);
    m_data.timeRounding = m_timeObserver.inferOfInstants(1.0 / layout.columns[layout.timeColumn].factor);
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const ReadColumn &column = layout.columns[i];
        FileColumn &described = m_data.layout.columns[i];
        if (column.role == ColumnRole::Channel) {
            ReferenceSeries &series = m_data.series[column.series];
            series.rounding = m_observers[column.series].infer(column.factor);
            if (isEmpty(series)) {
                described.role = ColumnRole::Ignored;
                described.reason = ColumnReason::NoNumber;
            }
        }
    }
    std::erase_if(m_data.series, isEmpty);
    return std::move(m_data);
}

void ReadLines::clear()
{
    rows.clear();
    skipped.clear();
    error.reset();
    count = 0;
    firstRow = 0;
}

ReadError timeFault(std::size_t line, const TableLayout &layout, std::string printed)
{
    return {line, layout.timeColumn + 1, std::move(printed), {ReadFault::Kind::TimeNotRising}};
}

void readLines(std::string_view lines, const TableLayout &layout, ReadLines &into)
{
    Row row;
    row.numbers.resize(layout.channels.size());
    const bool plainNumbers = layout.table.layout.decimalSign == DecimalSign::Point;
    CellScanner scanner(lines, layout.table.layout.delimiter, 1);
    while (!scanner.atEnd()) {
        const std::size_t line = scanner.line();
        if (!plainNumbers || !readPlainRow(scanner, layout, row)) {
            if (const std::optional<BadCell> bad = readRow(scanner, layout, row)) {
                if (bad->fault) {
                    leaveOut({line, bad->column, excerpt(bad->text), *bad->fault}, into.skipped);
                }
                continue;
            }
        }
        if (into.firstRow == 0) {
            into.firstRow = line;
            into.firstTime = excerpt(row.time.digits);
        } else if (!layout.isByAngle && !(row.time.value > into.rows.time().back())) {
            into.error = timeFault(line, layout, excerpt(row.time.digits));
            return;
        }
        row.line = line;
        into.rows.add(row);
    }
    into.count = scanner.line() - 1;
}

} // namespace slidercrank
