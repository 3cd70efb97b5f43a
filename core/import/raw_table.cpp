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
    void readCell(const Cell &cell, std::size_t column);
    void report(BadCell bad);

    std::size_t row() const { return m_table.lines.size() - 1; }

    const TableForm &m_form;
    RawTable &m_table;
    std::vector<std::size_t> m_badCounts; ///< by column; the last one is that of whole rows
};

void RowReader::report(BadCell bad)
{
    std::size_t &count = m_badCounts[bad.spoilsRow ? m_badCounts.size() - 1 : bad.column];
    if (count++ <= kMostSkippedRows) {
        m_table.badCells.push_back(std::move(bad));
    }
}

void RowReader::readCell(const Cell &cell, std::size_t column)
{
    std::string_view text = cell.text;
    const std::string_view unit = m_form.cellUnits[column];
    if (!unit.empty() && text.ends_with(unit)) {
        text = trimmed(text.substr(0, text.size() - unit.size()));
    }
    const CellNumber number = parseNumber(text, m_form.layout.decimalSign);
    m_table.columns[column].push_back(number.fault ? kUnreadable : number.value);
    if (number.fault) {
        report({row(), column, excerpt(cell.text), *number.fault});
    } else if (number.value == number.value) {
        m_table.roundings[column].observe(number.places, number.value);
    }
}

void RowReader::read(std::string_view line, std::size_t number)
{
    const std::size_t width = m_form.headings.size();
    std::optional<BadCell> spoiled;
    m_table.lines.push_back(number);
    std::size_t cells = 0;
    for (CellReader reader(line, m_form.layout.delimiter); reader.hasCell(); ++cells) {
        const Cell cell = reader.next();
        if (!cell.wellFormed && !spoiled) {
            spoiled = BadCell{row(), cells, excerpt(cell.text), RowFault::OpenQuotation, true};
        }
        if (cells < width) {
            readCell(cell, cells);
        } else if (!cell.text.empty() && !spoiled) {
            spoiled = BadCell{row(), cells, excerpt(cell.text), RowFault::TooManyCells, true};
        }
    }
    if (cells < m_form.fewestCells && !spoiled) {
        spoiled = BadCell{row(), cells - 1, {}, RowFault::TooFewCells, true};
    }
    for (std::size_t column = cells; column < width; ++column) {
        m_table.columns[column].push_back(kGap);
    }
    if (spoiled) {
        for (std::vector<double> &column : m_table.columns) {
            column.back() = kUnreadable;
        }
        report(*std::move(spoiled));
    }
}

/// How many rows there hardly are more of: memory that is never written to costs next to nothing, moving rows much.
std::size_t estimateRows(std::string_view data)
{
    constexpr std::size_t kLookedAt = std::size_t{1} << 16U;
    const std::string_view beginning = data.substr(0, kLookedAt);
    const auto ends =
        static_cast<double>(std::max(std::ranges::count(beginning, '\n'), std::ranges::count(beginning, '\r')));
    const double share =
        static_cast<double>(data.size()) / static_cast<double>(std::max<std::size_t>(beginning.size(), 1));
    return static_cast<std::size_t>(1.05 * ends * share) + 1;
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
    const std::size_t width = form.headings.size();
    RawTable table;
    table.columns.resize(width);
    table.roundings.resize(width);
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
