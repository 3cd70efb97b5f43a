// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/raw_table.h"

#include "core/import/cells.h"
#include "core/import/table_form.h"

#include <algorithm>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr double kUnreadable = std::numeric_limits<double>::infinity();
constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kFewestCells = 2; // a row with fewer is skipped; other missing cells at the end are gaps

/// Appends the rows of a file to the table.
class RowReader
{
public:
    RowReader(const TableForm &form, RawTable &table)
        : m_form(form)
        , m_table(table)
        , m_file(table.files.back())
        , m_badCounts(form.headings.size() + 1)
    {
    }

    void read(std::string_view line, std::size_t number);

private:
    void readCell(std::string_view cell, std::size_t column);
    void report(const BadCell &bad);

    RawColumn &column(std::size_t i) const { return m_table.columns[m_file.firstColumn + i]; }

    const TableForm &m_form;
    RawTable &m_table;
    TableFile &m_file;
    std::vector<std::size_t> m_badCounts; ///< by column; the last one counts spoiled rows
};

void RowReader::report(const BadCell &bad)
{
    std::size_t &count = bad.spoilsRow ? m_badCounts.back() : m_badCounts[bad.column];
    if (count++ <= kListedRows) {
        m_file.badCells.push_back(bad);
    }
}

void RowReader::readCell(std::string_view cell, std::size_t i)
{
    const std::string_view unit = m_form.cellUnits[i];
    const bool hasUnit = !unit.empty() && cell.ends_with(unit);
    const CellNumber number =
        parseNumber(hasUnit ? trimmed(cell.substr(0, cell.size() - unit.size())) : cell, m_form.layout.decimalSign);
    column(i).values.push_back(number.fault ? kUnreadable : number.value);
    if (number.fault) {
        report({m_file.lines.size() - 1, i, excerpt(cell), *number.fault});
    } else if (number.value == number.value) {
        column(i).rounding.observe(number.places, number.value);
    }
}

void RowReader::read(std::string_view line, std::size_t number)
{
    const std::size_t width = m_form.headings.size();
    BadCell spoiled;
    const auto spoil = [&](std::size_t at, std::string_view text, RowFault fault) {
        spoiled = spoiled.spoilsRow ? spoiled : BadCell{m_file.lines.size() - 1, at, excerpt(text), fault, true};
    };
    m_file.lines.push_back(number);
    std::size_t cells = 0;
    for (std::string_view rest = line; rest.data() != nullptr; ++cells) {
        const std::string_view cell = takeCell(rest, m_form.layout.delimiter);
        if (cells < width) {
            readCell(cell, cells);
        } else if (!cell.empty()) {
            spoil(cells, cell, RowFault::TooManyCells);
        }
    }
    if (cells < std::min(width, kFewestCells)) {
        spoil(cells - 1, {}, RowFault::TooFewCells);
    }
    for (std::size_t i = 0; i < width; ++i) {
        std::vector<double> &values = column(i).values;
        values.resize(m_file.lines.size(), kGap);
        values.back() = spoiled.spoilsRow ? kUnreadable : values.back();
    }
    if (spoiled.spoilsRow) {
        report(spoiled);
    }
}

/// Returns a number of rows that is rarely exceeded: reserving too much memory is cheap, moving rows is not.
std::size_t estimateRows(std::string_view data)
{
    const std::string_view beginning = data.substr(0, std::size_t{1} << 16U);
    const auto ends = std::max(std::ranges::count(beginning, '\n'), std::ranges::count(beginning, '\r'));
    const auto share = static_cast<double>(data.size()) / static_cast<double>(beginning.size() + 1);
    return static_cast<std::size_t>(1.05 * static_cast<double>(ends) * share) + 2;
}

/// Appends the columns of a file to the table, without rows.
void appendColumns(TableForm &form, const std::string &name, RawTable &table)
{
    const std::size_t before = table.columns.size();
    const std::size_t rows = estimateRows(form.data);
    table.files.push_back({before, form.layout.headerLine, form.firstDataLine, form.headerText});
    table.files.back().lines.reserve(rows);
    std::vector<std::vector<std::string>> preview = std::move(form.layout.rows);
    if (before == 0) {
        table.layout = form.layout;
        table.layout.rows.clear();
    }
    table.layout.files.push_back(name);
    table.layout.rows.resize(std::max(table.layout.rows.size(), preview.size()));
    for (std::size_t row = 0; row < preview.size(); ++row) {
        table.layout.rows[row].resize(before);
        std::ranges::move(preview[row], std::back_inserter(table.layout.rows[row]));
    }
    for (const Heading &heading : form.headings) {
        RawColumn &column = table.columns.emplace_back(RawColumn{.heading = heading, .index = table.columns.size()});
        column.use = {.heading = heading.printed, .unit = heading.unit, .file = table.files.size() - 1};
        column.values.reserve(rows);
    }
}

} // namespace

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
    return {file.headerLine, column.index - file.firstColumn + 1, excerpt(column.heading.printed), std::move(fault), {},
            column.use.file};
}

void readTable(std::string_view text, const FileBytes &file, const std::stop_token &stop,
               const std::function<void(std::size_t done)> &progress, RawTable &table)
{
    TableForm form = findTable(text);
    appendColumns(form, file.name, table);
    RowReader reader(form, table);
    constexpr std::size_t kReportEvery = std::size_t{1} << 18U; // bytes
    std::size_t reported = text.size();
    std::size_t number = form.firstDataLine;
    for (std::string_view rest = form.data; !rest.empty(); ++number) {
        if (reported - rest.size() >= kReportEvery) {
            reported = rest.size();
            progress(text.size() - rest.size());
            if (stop.stop_requested()) {
                throw ReadError{.fault = {ReadFault::Kind::Stopped}};
            }
        }
        if (const std::string_view line = takeLine(rest); !isBlankLine(line)) {
            reader.read(line, number);
        }
    }
    progress(text.size());
}

} // namespace slidercrank
