// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/table_form.h"

#include "core/import/reference_data.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = NameMeaning::Kind;

constexpr std::size_t kExaminedLines = 200; // that are not blank
constexpr std::size_t kLongestLine = std::size_t{1} << 20U;
constexpr std::string_view kDelimiters = "\t;,|";

using Lines = std::span<const Line>;

Lines firstLines(Lines lines)
{
    return lines.first(std::min(lines.size(), kExaminedLines));
}

/// The first row of numbers.
struct FirstRow {
    std::size_t line = 0; ///< index among the first lines
    char delimiter = ',';
    Cells cells{}; ///< without empty ones at the end
};

/// Returns whether all cells are gaps or numbers, with or without units, and at least two are numbers.
bool isRow(const Cells &cells)
{
    const auto isNumberOrGap = [](std::string_view cell) {
        const std::string_view number = splitUnit(cell).number;
        return !parseNumber(number, DecimalSign::Point).fault || !parseNumber(number, DecimalSign::Comma).fault;
    };
    const auto isNumber = [](std::string_view cell) { return looksNumeric(splitUnit(cell).number); };
    return std::ranges::all_of(cells, isNumberOrGap) && std::ranges::count_if(cells, isNumber) >= 2;
}

/// Cells are separated by spaces only if no other delimiter makes a row of any line.
std::optional<FirstRow> findFirstRow(Lines lines)
{
    for (const std::string_view delimiters : {kDelimiters, std::string_view(" ")}) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            for (const char delimiter : delimiters) {
                if (Cells cells = splitCells(lines[i].text, delimiter); isRow(cells)) {
                    return FirstRow{i, delimiter, std::move(cells)};
                }
            }
        }
    }
    return std::nullopt;
}

/// Removes the comment mark that some programs write before the headings, unless it is the first heading.
std::string_view withoutMark(std::string_view line)
{
    const std::string_view text = trimmed(line);
    for (const std::string_view mark : {"#", "%", "//"}) {
        const std::size_t end = text.starts_with(mark) ? text.find_first_not_of(mark[0]) : text.npos;
        if (end != text.npos && kDelimiters.find(text[end]) == kDelimiters.npos) {
            return trimmed(text.substr(end));
        }
    }
    return line;
}

/// A line, interpreted as headings.
struct Names {
    Cells cells{};
    char delimiter = ',';
    std::size_t times = 0;
    std::size_t quantities = 0;

    std::size_t known() const { return times + quantities; }
    bool isComplete() const { return times > 0 && quantities > 0; }
};

Names makeNames(Cells cells, char delimiter)
{
    Names names{std::move(cells), delimiter};
    for (const std::string_view cell : names.cells) {
        const Kind kind = looksNumeric(cell) ? Kind::Nothing : meaningOf(parseHeading(cell)).kind;
        names.times += kind == Kind::Time ? 1 : 0;
        names.quantities += kind >= Kind::Quantity ? 1 : 0;
    }
    return names;
}

/// Splits a line at the delimiter that yields most known names. Names above rows that are separated by spaces, or after
/// a comment mark, may have another delimiter than the numbers. Then there have to be as many as numbers, and only one
/// of those after a comment mark may be unknown.
Names readNames(std::string_view line, const std::optional<FirstRow> &row)
{
    const std::string_view text = withoutMark(line);
    const bool bySpaces = row && row->delimiter == ' ';
    const bool hasToFit = row && (bySpaces || text.size() != line.size());
    std::vector<Names> candidates;
    for (const char delimiter : kDelimiters) {
        candidates.push_back(makeNames(splitCells(text, delimiter), delimiter));
    }
    if (hasToFit) {
        for (const Cells &cells : {splitCells(text, ' '), splitAtBlanks(text, 2), splitAtBlanks(text, 1)}) {
            const Names names = makeNames(cells, ' ');
            if (bySpaces || (names.isComplete() && names.known() + 1 >= names.cells.size())) {
                candidates.push_back(names);
            }
        }
        std::erase_if(candidates, [&](const Names &names) { return names.cells.size() != row->cells.size(); });
    }
    if (candidates.empty()) {
        return bySpaces ? makeNames(splitCells(text, ' '), ' ') : Names();
    }
    return *std::ranges::max_element(candidates, {},
                                     [](const Names &names) { return std::pair(names.known(), names.cells.size()); });
}

struct HeaderFound {
    std::size_t line = 0;         ///< index among the first lines
    std::optional<Names> names{}; ///< nullopt if the line is the first row of numbers
};

/// Returns the first line that names a time and a quantity; else the line above the numbers with most names of either;
/// else the one directly above the numbers and units, if it has as many words; else, without numbers, the first line.
HeaderFound findHeader(Lines lines, const std::optional<FirstRow> &row)
{
    const auto isUnit = [](std::string_view cell) { return cell.empty() || parseUnit(cell); };
    HeaderFound best{row ? row->line : 0};
    std::size_t known = 0; // names in the best line
    for (std::size_t i = 0; i < lines.size(); ++i) {
        Names names = readNames(lines[i].text, row);
        const bool hasSize = row && names.cells.size() == row->cells.size();
        if (names.isComplete() && (hasSize || !row || row->delimiter != ' ')) {
            return {i, std::move(names)};
        }
        if (row && i >= row->line) {
            continue;
        }
        if (names.known() > known || (!row && i == 0)) {
            known = names.known();
            best = {i, std::move(names)};
        } else if (row && known == 0 && !std::ranges::all_of(names.cells, isUnit)) {
            const bool fits = hasSize && std::ranges::none_of(names.cells, looksNumeric);
            best = fits ? HeaderFound{i, std::move(names)} : HeaderFound{row->line};
        }
    }
    return best;
}

/// Returns the unit in a cell below the headings, which Simulink writes as "Type: double Unit: rad". Empty if there is
/// none.
std::string_view unitIn(std::string_view cell)
{
    constexpr std::string_view kUnit = "Unit:";
    if (const std::size_t at = cell.find(kUnit); at != cell.npos) {
        cell = trimmed(cell.substr(at + kUnit.size()));
        cell = cell.substr(0, cell.find_first_of(" \t;,"));
    } else if (cell.size() > 2 && (cell[0] == '[' || cell[0] == '(') && (cell.back() == ']' || cell.back() == ')')) {
        cell = trimmed(cell.substr(1, cell.size() - 2));
    }
    return parseUnit(cell) ? cell : std::string_view();
}

/// Sets the unit of a column that is found in cell `i` of a line, unless it is empty. Throws if the heading states
/// another one.
void setUnit(std::vector<Heading> &headings, std::size_t i, std::string_view unit, std::size_t line)
{
    if (unit.empty() || i >= headings.size()) {
        return;
    }
    FileColumn &column = headings[i].use;
    if (!column.unit.empty() && parseUnit(column.unit) != parseUnit(unit)) {
        throw ReadError{line, i + 1, excerpt(unit), {ReadFault::Kind::UnitsContradict, {}, excerpt(column.heading)}};
    }
    column.unit = unit;
}

/// Interprets the lines between the headings and the first number, which may contain units. Returns how many there are.
std::size_t readAnnotations(Lines lines, const std::optional<FirstRow> &row, std::vector<Heading> &headings)
{
    const auto isNumber = [](std::string_view cell) { return looksNumeric(splitUnit(cell).number); };
    std::size_t count = 0;
    for (; count < lines.size(); ++count) {
        const auto &[number, text] = lines[count];
        const Cells cells =
            row && row->delimiter != ' ' ? splitCells(text, row->delimiter) : readNames(text, row).cells;
        if (std::ranges::any_of(cells, isNumber)) {
            break;
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
            setUnit(headings, i, unitIn(cells[i]), number);
        }
    }
    return count;
}

/// Returns the decimal sign with which most numbers in the first lines can be read: 0,005 and 1.234,5 only with a
/// comma. Between commas, "1,234" could have a thousands separator and does not count.
DecimalSign findDecimalSign(Lines lines, char delimiter)
{
    int commas = 0; // more than points
    for (const Line &line : lines) {
        for (const std::string_view cell : splitCells(line.text, delimiter)) {
            const std::string text(splitUnit(cell).number);
            const bool isPoint = !parseNumber(text, DecimalSign::Point).fault;
            const bool isComma = !parseNumber(text, DecimalSign::Comma).fault &&
                                 (delimiter != ',' || parseNumber(text + ".0", DecimalSign::Point).fault);
            commas += (isComma ? 1 : 0) - (isPoint ? 1 : 0);
        }
    }
    return commas > 0 ? DecimalSign::Comma : DecimalSign::Point;
}

} // namespace

std::vector<Line> splitLines(std::string_view text)
{
    std::vector<Line> lines;
    std::size_t number = 0;
    while (!text.empty()) {
        std::string_view rest = takeUntil('\n', text);
        do {
            ++number;
            const std::string_view line = takeUntil('\r', rest);
            if (line.size() > kLongestLine && lines.size() < kExaminedLines) {
                throw ReadError{.line = number, .fault = {ReadFault::Kind::LineTooLong}};
            }
            if (line.find_first_not_of(" \t;,") != line.npos) {
                lines.push_back({number, line});
            }
        } while (!rest.empty());
    }
    return lines;
}

std::vector<Heading> takeHeadings(std::vector<Line> &lines, FileLayout &layout)
{
    const Lines examined = firstLines(lines);
    if (lines.empty()) {
        throw ReadError{.fault = {ReadFault::Kind::Empty}};
    }
    const std::optional<FirstRow> row = findFirstRow(examined);
    const HeaderFound header = findHeader(examined, row);
    const Lines preamble = examined.first(header.line);
    layout.delimiter = row ? row->delimiter : header.names->delimiter;
    Lines rows = Lines(lines).subspan(header.line + (header.names ? 1 : 0));
    std::vector<Heading> headings(header.names ? 0 : row->cells.size());
    if (header.names) {
        layout.headerLine = lines[header.line].number;
        std::ranges::transform(header.names->cells, std::back_inserter(headings), parseHeading);
        if (row && lines[row->line].text.starts_with('"') && row->cells.size() == headings.size() + 1) {
            headings.insert(headings.begin(), Heading()); // R writes row names without a heading
        }
        rows = rows.subspan(readAnnotations(firstLines(rows), row, headings));
    }
    for (std::size_t i = 0; row && i < std::min(row->cells.size(), headings.size()); ++i) {
        headings[i].cellUnit = splitUnit(row->cells[i]).unit;
        setUnit(headings, i, headings[i].cellUnit, lines[row->line].number);
    }
    const auto isAbove = [preamble](std::string_view beginning) {
        return std::ranges::any_of(preamble, [&](const Line &line) { return line.text.starts_with(beginning); });
    };
    interpretHeadings(headings, isAbove("Units are S.I. units") ? "m" : "",
                      isAbove("inDegrees=no") ? "rad" : ""); // OpenSim
    layout.decimalSign = findDecimalSign(firstLines(rows), layout.delimiter);
    lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(rows.size()));
    return headings;
}

} // namespace slidercrank
