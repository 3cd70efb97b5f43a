// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/table_form.h"

#include "core/import/cell_format.h"
#include "core/import/labelled_rows.h"
#include "core/import/listed_headings.h"
#include "core/import/reference_data.h"
#include "core/import/unit_lines.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace slidercrank
{

namespace
{

/// Finds the line of headings:
///
/// 1. the lines above the row that name one column each,
/// 2. else the first line, above or below the row, that names a time and a quantity and has as many cells as the row,
///    with the delimiter of the row or else with a different one,
/// 3. else, of the lines above the row, the one with most names,
/// 4. else, if there is no row of numbers, the first line,
/// 5. else the one directly above the numbers and their units, if it has as many cells as the row.
///
/// Returns nullopt if the file begins with the first row of numbers.
std::optional<HeadingCandidate> findHeader(Lines lines, const NumberRow &row)
{
    if (auto list = row.isFound() ? findListedHeadings(lines.first(row.line), row) : std::nullopt) {
        return list;
    }
    std::vector<HeadingCandidate> above;
    std::optional<HeadingCandidate> otherwiseSplit; // the first complete line whose delimiter is not that of the row
    for (std::size_t i = 0; i < lines.size(); ++i) {
        HeadingCandidate names = readNames(lines[i].text, row);
        names.line = i;
        const bool isComplete = names.isComplete() && (!row.isFound() || row.hasCountOf(names.cells));
        if (isComplete && (!row.isFound() || names.delimiter == row.delimiter)) {
            return names;
        }
        if (isComplete && !otherwiseSplit) {
            otherwiseSplit = names;
        }
        if (!row.isFound() || i < row.line) {
            above.push_back(std::move(names));
        }
    }
    if (otherwiseSplit) {
        return otherwiseSplit;
    }
    if (std::optional<HeadingCandidate> named = findLineWithMostNames(above, row)) {
        return named;
    }
    return row.isFound() ? findUnknownHeadings(above, row) : above.front();
}

/// Returns whether the first of the lines below the headings is the heading of the first column, which pandas prints
/// there.
bool beginsWithNameOfIndex(Lines rows, const NumberRow &row, std::size_t headings)
{
    return !rows.empty() && headings + 1 == row.cells.size() &&
           parseHeading(trimmed(rows.front().text)).meaning.kind != NameMeaning::Kind::Nothing;
}

/// Returns whether the first cell of each row is its name, which has no heading, as R and pandas write it: a quoted
/// text, a word, or a number counted from 0 or 1.
bool haveRowNames(Lines rows, char delimiter, std::size_t headings)
{
    constexpr std::size_t kExaminedRows = 2;
    if (rows.size() < kExaminedRows) {
        return false;
    }
    Cells numbers; // that are the names of rows
    for (const Line &row : rows.first(kExaminedRows)) {
        const Cells cells = splitCells(row.text, delimiter);
        if (cells.size() != headings + 1 || !std::all_of(cells.begin() + 1, cells.end(), isNumber)) {
            return false;
        }
        if (!row.text.starts_with('"') && looksNumeric(cells[0])) {
            numbers.push_back(cells[0]);
        }
    }
    return numbers.empty() || numbers == Cells{"0", "1"} || numbers == Cells{"1", "2"};
}

/// Interprets the lines between the headings and the numbers: the name of an index, units and further headings. Adds a
/// heading for row names without one. Returns the number of these lines.
std::size_t completeHeadings(Lines lines, const NumberRow &row, std::vector<Heading> &headings)
{
    std::size_t count = 0;
    if (beginsWithNameOfIndex(lines, row, headings.size())) {
        headings.insert(headings.begin(), parseHeading(trimmed(lines.front().text)));
        count = 1;
    }
    count += readAnnotations(firstLines(lines.subspan(count)), row, headings);
    if (haveRowNames(lines.subspan(count), row.delimiter, headings.size())) {
        headings.insert(headings.begin(), Heading());
    }
    return count;
}

/// Sets the units that follow the numbers in the cells of a row. `line`: number of its line.
void readUnitsInCells(const NumberRow &row, std::size_t line, std::vector<Heading> &headings)
{
    for (std::size_t i = 0; i < std::min(row.cells.size(), headings.size()); ++i) {
        headings[i].cells.unit = splitUnit(row.cells[i]).unit;
        setUnit(headings, i, headings[i].cells.unit, line);
    }
}

/// Returns how many empty headings at the end of a line of headings have cells below them: one in "Time,,Slider," above
/// "0,s,85,mm".
std::size_t countEmptyHeadings(Lines lines, const HeadingCandidate &header, const NumberRow &row)
{
    const bool isLastLine = header.line + 1 == lines.size();
    const Cells below =
        row.isFound() || isLastLine ? row.cells : splitCells(lines[header.line + 1].text, header.delimiter);
    const bool haveSeparators =
        header.delimiter != ' ' && countCells(lines[header.line].text, header.delimiter) >= below.size();
    return haveSeparators && below.size() > header.cells.size() ? below.size() - header.cells.size() : 0;
}

/// Reads a line of headings, and the lines of units and further headings directly above and below it.
TableTop readTop(Lines lines, const HeadingCandidate &header, const NumberRow &row)
{
    TableTop top{.headerLine = lines[header.line].number,
                 .firstRow = header.line + 1,
                 .delimiter = row.isFound() ? row.delimiter : header.delimiter};
    std::ranges::transform(headingsBeforeRemark(header.cells), std::back_inserter(top.headings), parseHeading);
    top.headings.resize(top.headings.size() + countEmptyHeadings(lines, header, row));
    if (header.line > 0) {
        readLineAbove(lines[header.line - 1], top.delimiter, top.headings);
    }
    NumberRow rowBelow = row;
    rowBelow.delimiter = top.delimiter;
    top.firstRow += completeHeadings(lines.subspan(top.firstRow), rowBelow, top.headings);
    return top;
}

/// Finds the headings above the first row of numbers. A file that begins with numbers has empty ones. Throws if the
/// quantities are the rows.
TableTop findTop(Lines lines, const NumberRow &row)
{
    const std::optional<HeadingCandidate> header = findHeader(lines, row);
    const bool isSure = header && header->isComplete() && std::ranges::none_of(header->cells, isNumber);
    if (!isSure && isTransposed(lines)) {
        throw ReadError{.line = lines.front().number, .fault = {ReadFault::Kind::Transposed}};
    }
    if (!header) {
        return {.headings = std::vector<Heading>(row.cells.size()), .firstRow = row.line, .delimiter = row.delimiter};
    }
    return readTop(lines, *header, row);
}

} // namespace

std::vector<Heading> takeHeadings(std::vector<Line> &lines, FileLayout &layout)
{
    if (lines.empty()) {
        throw ReadError{.fault = {ReadFault::Kind::Empty}};
    }
    const Lines examined = firstLines(lines);
    const NumberRow row = findFirstRow(examined);
    const std::optional<TableTop> labelled = row.isFound() ? std::nullopt : readLabelledRows(examined);
    if (!row.isFound() && !labelled && isProse(lines)) { // many words, whose meanings would take long to find
        throw ReadError{.fault = {ReadFault::Kind::NotATable}};
    }
    TableTop top = labelled ? *labelled : findTop(examined, row);
    layout.headerLine = top.headerLine;
    layout.delimiter = top.delimiter;
    readUnitsInCells(row, lines[row.line].number, top.headings);
    for (Heading &heading : top.headings) { // again, because the unit may be in a line of units or behind the numbers
        heading.meaning = meaningOf(heading.name, heading.use.unit);
    }
    lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(top.firstRow));
    if (!labelled && !lines.empty()) {
        markClocks(lines.front(), layout.delimiter, top.headings);
    }
    layout.decimalSign = findDecimalSign(firstLines(lines), layout.delimiter);
    layout.mayBeThousands = mayHaveThousands(firstLines(lines), layout.delimiter);
    return std::move(top.headings);
}

} // namespace slidercrank
