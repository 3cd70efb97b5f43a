// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/raw_table.h"

#include "core/import/cells.h"
#include "core/import/table_form.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace slidercrank
{

namespace
{

constexpr double kUnreadable = std::numeric_limits<double>::infinity();
constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

/// Fills the rows of a table, line by line.
class RowReader
{
public:
    RowReader(const TableForm &form, RawTable &table)
        : m_form(form)
        , m_table(table)
        , m_badCounts(form.headings.size() + 1)
    {
    }

    void read(std::string_view line, std::size_t number);

private:
    void readCell(std::string_view cell, std::size_t column);
    void report(std::size_t column, std::string_view text, RowFault fault, bool spoilsRow);

    const TableForm &m_form;
    RawTable &m_table;
    std::vector<std::size_t> m_badCounts; ///< by column; the last one is that of whole rows
};

void RowReader::report(std::size_t column, std::string_view text, RowFault fault, bool spoilsRow)
{
    std::size_t &count = m_badCounts[spoilsRow ? m_badCounts.size() - 1 : column];
    if (count++ <= kMostSkippedRows) {
        m_table.badCells.push_back({m_table.lines.size() - 1, column, excerpt(text), fault, spoilsRow});
    }
}

void RowReader::readCell(std::string_view cell, std::size_t column)
{
    const std::string_view unit = m_form.cellUnits[column];
    const bool hasUnit = !unit.empty() && cell.ends_with(unit);
    const CellNumber number =
        parseNumber(hasUnit ? trimmed(cell.substr(0, cell.size() - unit.size())) : cell, m_form.layout.decimalSign);
    m_table.columns[column].push_back(number.fault ? kUnreadable : number.value);
    if (number.fault) {
        report(column, cell, *number.fault, false);
    } else if (number.value == number.value) {
        m_table.roundings[column].observe(number.places, number.value);
    }
}

void RowReader::read(std::string_view line, std::size_t number)
{
    const std::size_t width = m_form.headings.size();
    std::optional<BadCell> spoiled;
    const auto spoil = [&](std::size_t column, std::string_view text, RowFault fault) {
        spoiled = spoiled ? spoiled : BadCell{0, column, std::string(text), fault};
    };
    m_table.lines.push_back(number);
    std::size_t cells = 0;
    for (std::string_view rest = line; rest.data() != nullptr; ++cells) {
        const Cell cell = takeCell(rest, m_form.layout.delimiter);
        if (!cell.wellFormed) {
            spoil(cells, cell.text, RowFault::OpenQuotation);
        }
        if (cells < width) {
            readCell(cell.text, cells);
        } else if (!cell.text.empty()) {
            spoil(cells, cell.text, RowFault::TooManyCells);
        }
    }
    if (cells < m_form.fewestCells) {
        spoil(cells - 1, {}, RowFault::TooFewCells);
    }
    for (std::size_t column = cells; column < width; ++column) {
        m_table.columns[column].push_back(kGap);
    }
    if (spoiled) {
        for (std::vector<double> &column : m_table.columns) {
            column.back() = kUnreadable;
        }
        report(spoiled->column, spoiled->text, spoiled->fault, true);
    }
}

/// How many rows there hardly are more of: memory that is never written to costs next to nothing, moving rows much.
std::size_t estimateRows(std::string_view data)
{
    const std::string_view beginning = data.substr(0, std::size_t{1} << 16U);
    const auto ends = std::max(std::ranges::count(beginning, '\n'), std::ranges::count(beginning, '\r'));
    const auto share = static_cast<double>(data.size()) / static_cast<double>(beginning.size() + 1);
    return static_cast<std::size_t>(1.05 * static_cast<double>(ends) * share) + 2;
}

} // namespace

std::variant<RawTable, ReadError> readTable(std::string_view text, const std::stop_token &stop,
                                            const std::function<void(std::size_t done)> &progress)
{
    std::variant<TableForm, ReadError> outcome = findTable(text);
    if (ReadError *const error = std::get_if<ReadError>(&outcome)) {
        return std::move(*error);
    }
    TableForm &form = std::get<TableForm>(outcome);
    RawTable table;
    table.columns.resize(form.headings.size());
    table.roundings.resize(form.headings.size());
    const std::size_t rows = estimateRows(form.data);
    table.lines.reserve(rows);
    for (std::vector<double> &column : table.columns) {
        column.reserve(rows);
    }
    RowReader reader(form, table);
    constexpr std::size_t kReportEvery = std::size_t{1} << 18U; // bytes
    std::size_t reported = text.size();
    std::size_t number = form.firstDataLine;
    for (std::string_view rest = form.data; !rest.empty(); ++number) {
        if (reported - rest.size() >= kReportEvery) {
            reported = rest.size();
            if (stop.stop_requested()) {
                return ReadError{0, 0, {}, {ReadFault::Kind::Stopped}};
            }
            if (progress) {
                progress(text.size() - rest.size());
            }
        }
        if (const std::string_view line = takeLine(rest); !isBlankLine(line)) {
            reader.read(line, number);
        }
    }
    if (progress) {
        progress(text.size());
    }
    table.layout = std::move(form.layout);
    table.headings = std::move(form.headings);
    table.headerText = std::move(form.headerText);
    table.firstDataLine = form.firstDataLine;
    return table;
}

} // namespace slidercrank
