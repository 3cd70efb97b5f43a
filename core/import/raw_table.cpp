// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/raw_table.h"

#include "core/import/cells.h"
#include "core/import/file_text.h"
#include "core/import/vocabulary.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kUnreadable = kInfinity;
constexpr std::size_t kMinCells = 2; // in a row that can be read

/// Parses a cell of a column. A number whose spelling implies a unit, such as a multiple of π, has the fault NotANumber
/// if the column has a different unit.
CellNumber parseCell(const RawColumn &column, std::string_view cell, DecimalSign decimalSign)
{
    if (const std::string_view label = column.cells.label; cell.starts_with(label)) {
        cell = trimmed(cell.substr(label.size()));
    }
    const std::string_view unit = column.cells.unit;
    if (!unit.empty() && cell.ends_with(unit)) {
        cell = trimmed(cell.substr(0, cell.size() - unit.size()));
    }
    CellNumber number = column.cells.isClock ? parseClock(cell) : parseNumber(cell, decimalSign);
    if (!number.unit.empty() && !column.use.unit.empty() && parseUnit(column.use.unit) != parseUnit(number.unit)) {
        number = {.fault = RowFault::NotANumber};
    }
    return number;
}

/// Reads a row into the columns of its file, and lets each column's RoundingObserver see the number. Cells that are no
/// numbers become kUnreadable. If the row has non-empty cells beyond the last column, or fewer than file.fewestCells
/// cells, all its values become kUnreadable; other missing cells at its end are gaps. Returns the number of cells.
std::size_t readRow(RawTable &table, const TableFile &file, std::size_t row)
{
    const std::span<RawColumn> columns = table.columnsOf(file);
    bool hasTooManyCells = false;
    std::size_t cells = 0;
    for (std::string_view rest = file.rows[row].text; rest.data() != nullptr; ++cells) {
        const std::string_view cell = takeCell(rest, file.layout.delimiter);
        if (cells >= columns.size()) {
            hasTooManyCells = hasTooManyCells || !cell.empty();
            continue;
        }
        RawColumn &column = columns[cells];
        CellNumber number = parseCell(column, cell, file.layout.decimalSign);
        if (number.value == column.cells.missing) {
            number = {};
        }
        if (!number.unit.empty()) {
            column.use.unit = number.unit; // it had this unit or none
        }
        column.values[row] = number.fault ? kUnreadable : number.value;
        if (!std::isnan(number.value)) {
            column.rounding.observe(number.places, number.value);
        }
    }
    if (hasTooManyCells || cells < file.fewestCells) {
        std::ranges::for_each(columns, [row](RawColumn &column) { column.values[row] = kUnreadable; });
    }
    return cells;
}

/// Returns the smallest number of cells of a row that can be read. Between spaces, a gap in the middle cannot be
/// distinguished from one at the end. So a row with fewer cells than the longest row cannot be read, unless at least
/// half of the rows have fewer. `counts`: numbers of cells of all rows.
std::size_t fewestCellsOf(const TableFile &file, std::span<const std::size_t> counts)
{
    const std::size_t longest = counts.empty() ? 0 : std::min(std::ranges::max(counts), file.width);
    const auto shorter = std::ranges::count_if(counts, [longest](std::size_t cells) { return cells < longest; });
    const bool areGapsOpen = file.layout.delimiter == ' ' && 2 * shorter < std::ssize(counts);
    return areGapsOpen ? longest : std::min(file.width, kMinCells);
}

/// Returns whether a row begins with the name of a statistic, such as "Mean".
bool isStatistic(const TableFile &file, const Line &row)
{
    std::string_view rest = row.text;
    return namesStatistic(wordsOf(takeCell(rest, file.layout.delimiter)));
}

/// Returns the number of rows above the footer. The footer consists of the last rows whose first cell is a word
/// ("Mean") or, if the whole first column contains words, the name of a statistic. A footer has fewer rows than remain
/// above.
std::size_t countRowsAboveFooter(const TableFile &file, const RawColumn &first)
{
    const auto isWord = [](double value) { return std::isinf(value); };
    const bool areWords = std::ranges::all_of(first.values, isWord);
    std::size_t end = first.values.size();
    while (end > 0 && (areWords ? isStatistic(file, file.rows[end - 1]) : isWord(first.values[end - 1]))) {
        --end;
    }
    return 2 * end > first.values.size() ? end : first.values.size();
}

/// Returns the number of rows at the beginning that begin with the name of a statistic. Rows that
/// begin with another word are kept: the first one may have the name of all rows, in merged cells.
std::size_t countStatisticsAbove(const TableFile &file)
{
    const auto first = std::ranges::find_if_not(file.rows, [&file](const Line &row) { return isStatistic(file, row); });
    return static_cast<std::size_t>(first - file.rows.begin());
}

/// Finds the number that a logger or a scientific format wrote for a missing value: the smallest or largest value, if
/// it is one of kMissingValues, and farther from the other values than these are from each other. Returns NaN if there
/// is none.
double findMissingValue(const RawColumn &column)
{
    constexpr std::array<double, 12> kMissingValues{-999.0, -9999.0, -99999.0,   -999999.0,
                                                    9999.0, 99999.0, 999999.0,   1e20,
                                                    1e30,   -1e30,   9.96921e36, 9.969209968386869e36};
    const ValueRange all = rangeOf(column.values);
    for (const double extreme : {all.low, all.high}) {
        if (std::ranges::count(kMissingValues, extreme) == 0) {
            continue;
        }
        ValueRange others;
        std::ranges::for_each(column.values, [&](double value) { others.include(value == extreme ? kNone : value); });
        const double distance = std::max(others.low - extreme, extreme - others.high);
        if (others.count > 0 && distance > others.width()) {
            return extreme;
        }
    }
    return kNone;
}

/// Turns the numbers of all rows before `begin` and from `end` on into gaps: they are no data. Reads the rows between
/// again, so that only their digits count for the rounding of the columns.
void keepRows(RawTable &table, const TableFile &file, std::size_t begin, std::size_t end)
{
    for (RawColumn &column : table.columnsOf(file)) {
        column.rounding = {};
        for (std::size_t row = 0; row < column.values.size(); ++row) {
            const bool isKept = row >= begin && row < end;
            column.values[row] = isKept || !std::isfinite(column.values[row]) ? column.values[row] : kNone;
        }
    }
    for (std::size_t row = begin; row < end; ++row) {
        readRow(table, file, row);
    }
}

/// Throws if there are more headings than `longest`, the number of cells of the longest row, because a heading contains
/// the delimiter. Two exceptions: all headings with cells are known, and all without cells are unknown (remarks), or
/// the rows have a single cell (the delimiter is wrong, which is reported elsewhere).
void requireCellForEachHeading(std::span<const RawColumn> columns, const TableFile &file, std::size_t longest)
{
    const auto isKnown = [](const RawColumn &column) { return column.meaning.kind != NameMeaning::Kind::Nothing; };
    const std::size_t used = std::min(longest, columns.size());
    const bool areRemarks =
        std::ranges::all_of(columns.first(used), isKnown) && std::ranges::none_of(columns.subspan(used), isKnown);
    if (used < columns.size() && longest >= kMinCells && !areRemarks) {
        throw ReadError{
            .line = file.layout.headerLine,
            .fault = {.kind = ReadFault::Kind::MoreHeadings, .headingCount = columns.size(), .cellCount = longest}};
    }
}

/// Appends a file and its columns to a table. The columns have their headings, and gaps as values.
TableFile &addFile(const FileBytes &bytes, RawTable &table)
{
    TableFile &file = table.files.emplace_back();
    file.name = bytes.name;
    file.firstColumn = table.columns.size();
    std::vector<Line> lines = splitLines(decodeText(bytes.bytes, file.converted));
    const std::vector<Heading> headings = takeHeadings(lines, file.layout);
    file.rows = std::move(lines);
    file.width = headings.size();
    file.fewestCells = std::min(file.width, kMinCells);
    for (const Heading &heading : headings) {
        RawColumn &column = table.columns.emplace_back(
            RawColumn{heading.use, heading.name, heading.cells, heading.meaning, table.columns.size()});
        column.use.file = table.files.size() - 1;
        column.values.assign(file.rows.size(), kNone);
    }
    return file;
}

/// Reads all rows of a file into its columns, and returns their numbers of cells. Throws if `progress` stops it.
std::vector<std::size_t> readRows(RawTable &table, const TableFile &file,
                                  const std::function<bool(double fraction)> &progress)
{
    constexpr std::size_t kReportEvery = 4096; // rows
    std::vector<std::size_t> counts;
    counts.reserve(file.rows.size());
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
        counts.push_back(readRow(table, file, row));
        const std::size_t done = row + 1;
        if ((done % kReportEvery == 0 || done == file.rows.size()) &&
            !progress(static_cast<double>(done) / static_cast<double>(file.rows.size()))) {
            throw ReadError{.fault = {ReadFault::Kind::Stopped}};
        }
    }
    return counts;
}

/// A fault of a row, and the index of the cell with the fault.
struct CellFault {
    std::size_t cell = 0;
    RowFault fault{};
};

/// Returns why a row is skipped, in this order:
///
/// 1. the fault of the cell of `column`,
/// 2. TooManyCells: the first cell beyond the headings that is not empty,
/// 3. RepeatedTime, if the value of `column` is readable,
/// 4. if `column` is the abscissa and has a gap: the fault of the first cell (a word, as in a footer), or else NoTime,
/// 5. TooFewCells, if the row has fewer than file.fewestCells cells,
/// 6. TooLarge: the value became infinite when it was converted to the default unit.
///
/// `column`: the one that is unreadable in this row, or the abscissa if all are readable but the time is repeated.
/// `cells`: the cells of the row in the file of this column.
CellFault findCellFault(const RawTable &table, const RawColumn &column, std::size_t row, const Cells &cells)
{
    const TableFile &file = table.fileOf(column);
    const auto faultIn = [&](const RawColumn &other) {
        const std::size_t cell = other.index - file.firstColumn;
        return parseCell(other, cell < cells.size() ? cells[cell] : std::string_view(), file.layout.decimalSign).fault;
    };
    const std::size_t own = column.index - file.firstColumn;
    if (const std::optional<RowFault> fault = faultIn(column)) {
        return {own, *fault};
    }
    if (cells.size() > file.width) {
        const auto isFilled = [](std::string_view cell) { return !cell.empty(); };
        const auto beyond =
            std::find_if(cells.begin() + static_cast<std::ptrdiff_t>(file.width), cells.end(), isFilled);
        return {static_cast<std::size_t>(beyond - cells.begin()), RowFault::TooManyCells};
    }
    if (!column.isUnreadable(row)) {
        return {own, RowFault::RepeatedTime};
    }
    if (std::isnan(column.values[row])) {
        const std::optional<RowFault> atBeginning = faultIn(table.columns[file.firstColumn]);
        return atBeginning ? CellFault{0, *atBeginning} : CellFault{own, RowFault::NoTime};
    }
    return {own, cells.size() < file.fewestCells ? RowFault::TooFewCells : RowFault::TooLarge};
}

} // namespace

std::vector<double> RawColumn::finiteValues() const
{
    std::vector<double> finite = values;
    std::erase_if(finite, [](double value) { return !std::isfinite(value); });
    return finite;
}

bool RawColumn::isUnreadable(std::size_t row) const
{
    return isUsed() && (std::isinf(values[row]) || (isAbscissa() && std::isnan(values[row])));
}

RawColumn *RawTable::abscissa()
{
    return findElement(columns, &RawColumn::isAbscissa);
}

void convert(RawColumn &column, const Unit &unit)
{
    std::ranges::for_each(column.values, [&unit](double &value) { value = unit.toDefault(value); });
    column.factor = unit.toDefault(1.0);
}

ReadError errorAtHeading(const RawTable &table, const RawColumn &column, ReadFault fault)
{
    const TableFile &file = table.fileOf(column);
    return {.line = file.layout.headerLine,
            .column = column.index - file.firstColumn + 1,
            .text = excerpt(column.use.heading),
            .fault = std::move(fault),
            .file = column.use.file};
}

void readTable(const FileBytes &bytes, const std::function<bool(double fraction)> &progress, RawTable &table)
{
    TableFile &file = addFile(bytes, table);
    const std::vector<std::size_t> counts = readRows(table, file, progress);
    const std::span<RawColumn> columns = table.columnsOf(file);
    requireCellForEachHeading(columns, file, counts.empty() ? 0 : std::ranges::max(counts));
    file.fewestCells = fewestCellsOf(file, counts);
    const bool hasShortRows =
        std::ranges::any_of(counts, [&file](std::size_t cells) { return cells < file.fewestCells; });
    const std::size_t begin = countStatisticsAbove(file);
    const std::size_t end = columns.empty() ? file.rows.size() : countRowsAboveFooter(file, columns.front());
    bool hasMissingValues = false;
    for (RawColumn &column : columns) {
        column.cells.missing = findMissingValue(column);
        hasMissingValues = hasMissingValues || !std::isnan(column.cells.missing);
    }
    if (begin > 0 || end < file.rows.size() || hasMissingValues || hasShortRows) {
        keepRows(table, file, begin, end);
    }
}

SkippedRow findRowFault(RawTable &table, std::size_t row)
{
    const RawColumn *const unreadable =
        findElement(table.columns, [row](const RawColumn &column) { return column.isUnreadable(row); });
    const RawColumn &column = unreadable ? *unreadable : *table.abscissa();
    const TableFile &file = table.fileOf(column);
    const Line &line = file.rows[row];
    const Cells cells = splitCells(line.text, file.layout.delimiter);
    const CellFault found = findCellFault(table, column, row, cells);
    const std::string_view text = found.cell < cells.size() ? cells[found.cell] : std::string_view();
    return {line.number, found.cell + 1, excerpt(text), found.fault, column.use.file};
}

FileLayout describeLayout(const RawTable &table)
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
