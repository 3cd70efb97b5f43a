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

/// Fills the rows of a file, line by line.
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

    std::vector<double> &column(std::size_t i) const { return m_table.columns[m_file.firstColumn + i]; }

    const TableForm &m_form;
    RawTable &m_table;
    TableFile &m_file;
    std::vector<std::size_t> m_badCounts; ///< by column; the last one is that of whole rows
};

void RowReader::report(const BadCell &bad)
{
    std::size_t &count = bad.spoilsRow ? m_badCounts.back() : m_badCounts[bad.column];
    if (count++ <= kMostSkippedRows) {
        m_file.badCells.push_back(bad);
    }
}

void RowReader::readCell(std::string_view cell, std::size_t i)
{
    const std::string_view unit = m_form.cellUnits[i];
    const bool hasUnit = !unit.empty() && cell.ends_with(unit);
    const CellNumber number =
        parseNumber(hasUnit ? trimmed(cell.substr(0, cell.size() - unit.size())) : cell, m_form.layout.decimalSign);
    column(i).push_back(number.fault ? kUnreadable : number.value);
    if (number.fault) {
        report({m_file.lines.size() - 1, i, excerpt(cell), *number.fault});
    } else if (number.value == number.value) {
        m_table.roundings[m_file.firstColumn + i].observe(number.places, number.value);
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
    for (std::size_t i = 0; i < width; ++i) {
        column(i).resize(m_file.lines.size(), kGap);
        column(i).back() = spoiled.spoilsRow ? kUnreadable : column(i).back();
    }
    if (spoiled.spoilsRow) {
        report(spoiled);
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

/// Names the column of a plot that is alone in its file by the name of the file, where its heading says nothing.
void nameByFile(std::vector<Heading> &headings, const std::string &file)
{
    for (std::size_t i = 0; headings.size() == 2 && i < 2; ++i) {
        Heading &heading = headings[i];
        if (headings[1 - i].meaning.kind != NameMeaning::Kind::Time || !saysNothing(heading)) {
            continue;
        }
        Heading byFile = parseHeading(file.substr(0, file.find_last_of('.')));
        byFile.printed = heading.printed;
        byFile.unit = heading.unit.empty() ? byFile.unit : heading.unit;
        byFile.meaning = meaningOf(byFile);
        byFile.isFromFileName = true;
        if (byFile.meaning.kind >= NameMeaning::Kind::Channel) {
            heading = std::move(byFile);
        }
    }
}

/// Appends the form of a file to the table.
void append(TableForm &form, const std::string &name, RawTable &table)
{
    nameByFile(form.headings, name);
    const std::size_t before = table.headings.size();
    table.files.push_back({before, form.layout.headerLine, form.firstDataLine, form.headerText});
    if (table.files.size() == 1) {
        table.layout = form.layout;
        table.layout.rows.clear();
    }
    table.layout.files.push_back(name);
    table.layout.rows.resize(std::max(table.layout.rows.size(), form.layout.rows.size()));
    for (std::size_t row = 0; row < form.layout.rows.size(); ++row) {
        table.layout.rows[row].resize(before);
        std::ranges::copy(form.layout.rows[row], std::back_inserter(table.layout.rows[row]));
    }
    const std::size_t rows = estimateRows(form.data);
    for (const Heading &heading : form.headings) {
        table.layout.columns.push_back(
            {.heading = heading.printed, .unit = heading.unit, .file = table.files.size() - 1});
        table.headings.push_back(heading);
        table.columns.emplace_back().reserve(rows);
    }
    table.roundings.resize(table.headings.size());
    table.files.back().lines.reserve(rows);
}

} // namespace

void readTable(std::string_view text, const FileBytes &file, const std::stop_token &stop,
               const std::function<void(std::size_t done)> &progress, RawTable &table)
{
    TableForm form = findTable(text);
    append(form, file.name, table);
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
