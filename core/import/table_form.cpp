// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/table_form.h"

#include "core/import/cells.h"
#include "core/import/unit_text.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = NameMeaning::Kind;

constexpr std::size_t kLinesLookedAt = 200; // for the names, blank ones not counted
constexpr std::size_t kLongestLine = std::size_t{1} << 20U;
constexpr std::size_t kPreviewRows = 6;
constexpr std::string_view kDelimiters = "\t;,";

/// A line that is not blank.
struct Line {
    std::size_t number = 0; ///< from 1
    std::string_view text;
    std::string_view below; ///< everything behind it
};

std::vector<Line> firstLines(std::string_view text, std::size_t number = 1)
{
    std::vector<Line> lines;
    for (; !text.empty() && lines.size() < kLinesLookedAt; ++number) {
        const std::string_view line = takeLine(text);
        if (!isBlankLine(line)) {
            lines.push_back({number, line, text});
        }
    }
    return lines;
}

/// The first row of numbers.
struct FirstRow {
    std::size_t line = 0; ///< index among the first lines
    char delimiter = ',';
    Cells cells{}; ///< without empty ones at the end

    bool isBySpaces() const { return delimiter == ' '; }
};

/// Whether all cells are numbers, perhaps with units, or gaps, and two at least numbers.
bool isRow(const Cells &cells)
{
    const auto isNumberOrGap = [](std::string_view cell) {
        const std::string_view number = splitUnit(cell).number;
        return !parseNumber(number, DecimalSign::Point).fault || !parseNumber(number, DecimalSign::Comma).fault;
    };
    const auto isNumber = [](std::string_view cell) { return looksNumeric(splitUnit(cell).number); };
    return std::ranges::all_of(cells, isNumberOrGap) && std::ranges::count_if(cells, isNumber) >= 2;
}

/// Spaces separate the cells only where no other delimiter makes a row of any line.
std::optional<FirstRow> findFirstRow(std::span<const Line> lines, std::string_view delimiters)
{
    for (const std::string_view tried : {delimiters, std::string_view(delimiters == kDelimiters ? " " : "")}) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            for (const char delimiter : tried) {
                if (Cells cells = splitCells(lines[i].text, delimiter); isRow(cells)) {
                    return FirstRow{i, delimiter, std::move(cells)};
                }
            }
        }
    }
    return std::nullopt;
}

/// Without the mark of a comment that programs put before the names; not where the mark is the name of a column.
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

/// A line read as the names of columns.
struct Names {
    Cells cells{};
    char delimiter = kDelimiters.back();
    std::size_t times = 0;
    std::size_t quantities = 0;
    bool fits = true; ///< as many as there are cells in the first row, where that counts

    std::size_t known() const { return times + quantities; }
    bool isComplete() const { return times > 0 && quantities > 0 && fits; }
};

Names makeNames(Cells cells, char delimiter)
{
    Names names{std::move(cells), delimiter};
    for (const std::string_view cell : names.cells) {
        const Kind kind = looksNumeric(cell) ? Kind::Nothing : meaningOf(parseHeading(cell)).kind;
        names.times += kind == Kind::Time ? 1 : 0;
        names.quantities += kind == Kind::Channel || kind == Kind::Quantity ? 1 : 0;
    }
    return names;
}

/// The reading of the line that recognizes most names. Above rows between spaces, or behind the mark of a comment,
/// names may be separated otherwise than the numbers; then there have to be as many, and behind a mark hardly any other
/// word.
Names readNames(std::string_view line, std::string_view delimiters, const std::optional<FirstRow> &row)
{
    const std::string_view text = withoutMark(line);
    const bool mustFit = row && (row->isBySpaces() || text.size() != line.size());
    Names best;
    const auto offer = [&](Names names) {
        const bool fits = !mustFit || names.cells.size() == row->cells.size();
        const bool isMore = std::pair(names.known(), names.cells.size()) > std::pair(best.known(), best.cells.size());
        best = fits && isMore ? std::move(names) : best;
    };
    for (const char delimiter : delimiters) {
        offer(makeNames(splitCells(text, delimiter), delimiter));
    }
    if (mustFit) {
        for (Cells cells : {splitCells(text, ' '), splitBetweenBlanks(text, 2), splitBetweenBlanks(text, 1)}) {
            Names names = makeNames(std::move(cells), row->delimiter);
            if (row->isBySpaces() || (names.isComplete() && names.known() + 1 >= names.cells.size())) {
                offer(std::move(names));
            }
        }
    }
    if (best.cells.empty() && row && row->isBySpaces()) {
        best = makeNames(splitCells(text, ' '), ' ');
        best.fits = false;
    }
    return best;
}

struct HeaderFound {
    std::size_t line = 0;         ///< index among the first lines
    std::optional<Names> names{}; ///< none: the line holds numbers already
};

/// The first line that names a time and a quantity; else the one that names most of either above the numbers; else the
/// line right above the numbers; else, where there are none, the first line.
HeaderFound findHeader(const std::vector<Line> &lines, std::string_view delimiters, const std::optional<FirstRow> &row)
{
    HeaderFound best;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        Names names = readNames(lines[i].text, delimiters, row);
        if (names.isComplete()) {
            return {i, std::move(names)};
        }
        if ((!row || i < row->line) && (i == 0 || names.known() > best.names->known())) {
            best = {i, std::move(names)};
        }
    }
    if (!row || (best.names && best.names->known() > 0)) {
        return best;
    }
    for (std::size_t i = row->line; i-- > 0;) {
        Names names = readNames(lines[i].text, delimiters, row);
        const auto isUnit = [](std::string_view cell) { return cell.empty() || parseUnit(cell); };
        if (std::ranges::all_of(names.cells, isUnit)) {
            continue; // a line of units
        }
        if (names.cells.size() == row->cells.size() && std::ranges::none_of(names.cells, looksNumeric)) {
            return {i, std::move(names)};
        }
        break;
    }
    return {row->line};
}

/// How many cells a row needs: all that have a heading, or as many as the longest of the first rows has where the names
/// behind mean nothing.
std::size_t countNeededCells(const TableForm &form)
{
    std::size_t most = 0;
    for (const Line &row : firstLines(form.data)) {
        most = std::max(most, splitCells(row.text, form.layout.delimiter).size());
    }
    const std::span headings(form.headings);
    const auto meansNothing = [](const Heading &heading) { return meaningOf(heading).kind == Kind::Nothing; };
    const bool isSpare =
        most >= 2 && most < headings.size() && std::ranges::all_of(headings.subspan(most), meansNothing);
    return isSpare ? most : headings.size();
}

/// What a cell below the names says of its column: "[mm]", "-" and "Type: double Unit: rad", as Simulink's data
/// inspector writes it. Nothing where it says nothing of this kind; an empty text where it gives no unit.
std::optional<std::string_view> readAnnotation(std::string_view cell)
{
    constexpr std::string_view kUnit = "Unit:";
    const bool isBracketed =
        (cell.starts_with('[') && cell.ends_with(']')) || (cell.starts_with('(') && cell.ends_with(')'));
    const std::string_view unit = isBracketed ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
    if (parseUnit(unit)) {
        return unit;
    }
    if (const std::size_t at = cell.find(kUnit); at != cell.npos) {
        const std::string_view value = trimmed(cell.substr(at + kUnit.size()));
        return value.substr(0, value.find_first_of(" \t;,"));
    }
    const std::size_t colon = cell.find(':');
    const bool isEntry = colon != cell.npos && colon > 0 && cell.find_first_of(" \t") > colon;
    return unit == "-" || isEntry ? std::optional(std::string_view()) : std::nullopt;
}

/// The units in a line below the names; nothing where it is a line of data.
std::optional<Cells> readAnnotations(const Cells &cells)
{
    Cells units;
    std::size_t found = 0;
    for (const std::string_view cell : cells) {
        const std::optional<std::string_view> unit = readAnnotation(cell);
        found += unit ? 1 : 0;
        units.push_back(unit.value_or(""));
    }
    const std::size_t filled = cells.size() - static_cast<std::size_t>(std::ranges::count(cells, std::string_view()));
    const bool isData = found == 0 || 2 * found < filled || std::ranges::any_of(cells, looksNumeric);
    return isData ? std::nullopt : std::optional(std::move(units));
}

/// Gives the columns these units, which stand in that line. Throws where a heading says otherwise.
void takeUnits(TableForm &form, const Cells &units, std::size_t line)
{
    for (std::size_t i = 0; i < std::min(units.size(), form.headings.size()); ++i) {
        Heading &heading = form.headings[i];
        const bool isNew = !units[i].empty();
        if (isNew && !heading.unit.empty() && parseUnit(heading.unit) != parseUnit(units[i])) {
            const ReadFault fault{ReadFault::Kind::UnitsContradict, {}, excerpt(heading.printed)};
            throw ReadError{line, i + 1, excerpt(units[i]), fault};
        }
        heading.unit = isNew ? units[i] : heading.unit;
    }
}

/// Takes the lines of units and of other annotations below the names.
void takeAnnotations(TableForm &form, std::string_view delimiters, const std::optional<FirstRow> &row)
{
    const std::vector<Line> lines = firstLines(form.data, form.firstDataLine);
    const auto cellsIn = [&](const Line &line) {
        return row && row->isBySpaces() ? readNames(line.text, delimiters, row).cells
                                        : splitCells(line.text, form.layout.delimiter);
    };
    for (const Line &line : lines) {
        const Cells cells = cellsIn(line);
        const std::optional<Cells> units = readAnnotations(cells);
        const bool areOtherNames = &line == &lines[0] && lines.size() > 1 && cells.size() == form.headings.size() &&
                                   std::ranges::none_of(cells, looksNumeric) && readAnnotations(cellsIn(lines[1]));
        if (!units && areOtherNames) {
            continue; // short ones, above the units
        }
        if (!units) {
            break;
        }
        const bool hasUnit = std::ranges::any_of(*units, [](std::string_view unit) { return !unit.empty(); });
        form.layout.unitsLine = hasUnit ? line.number : form.layout.unitsLine;
        form.data = line.below;
        form.firstDataLine = line.number + 1;
        takeUnits(form, *units, line.number);
    }
}

/// Settles what the headings mean. The lines above them may give units: "inDegrees=no", "Units are S.I. units (second,
/// meters, …)", as OpenSim writes them.
void interpretHeadings(TableForm &form, std::span<const Line> above)
{
    std::string unitOfLengths;
    std::string unitOfAngles;
    std::size_t line = 0;
    for (const Line &each : above) {
        const std::string_view text = trimmed(each.text);
        const bool isOfLengths = text.starts_with("Units are S.I. units");
        const bool isOfAngles = isAmong(text, "inDegrees=yes inDegrees=no");
        unitOfLengths = isOfLengths ? "m" : unitOfLengths;
        unitOfAngles = isOfAngles ? text.ends_with("yes") ? "deg" : "rad" : unitOfAngles;
        line = line == 0 && (isOfLengths || isOfAngles) ? each.number : line;
    }
    if (interpretHeadings(form.headings, unitOfLengths, unitOfAngles)) {
        form.layout.unitsLine = line;
    }
}

/// The decimal sign of a file. The first number that can be read in one way only decides: 0,005 and 74,5436 and 1.234,5
/// hold a decimal comma; 74,543 alone could be thousands. Where commas separate the cells as well, a decimal comma
/// stands in quoted cells only, and in no file beside decimal points.
DecimalSign findDecimalSign(const TableForm &form)
{
    const bool commasSeparate = form.layout.delimiter == ',';
    if (form.data.find(commasSeparate ? '"' : ',') == form.data.npos) {
        return DecimalSign::Point;
    }
    bool isSurelyComma = false;
    bool hasCommas = false;
    bool hasPoints = false;
    for (std::string_view rest = form.data; !rest.empty();) {
        for (const std::string_view cell : splitCells(takeLine(rest), form.layout.delimiter)) {
            const std::string_view text = splitUnit(cell).number;
            const bool isPoint = !parseNumber(text, DecimalSign::Point).fault;
            const bool isComma = !parseNumber(text, DecimalSign::Comma).fault;
            const std::size_t sign = text.find_first_of(".,");
            const std::size_t first = text.find_first_of("0123456789");
            if (isPoint == isComma || sign == text.npos) {
                continue;
            }
            const bool mayBeThousands = text.size() == sign + 4 && first < sign && sign - first <= 3 &&
                                        text[first] != '0' && std::ranges::all_of(text.substr(sign + 1), isDigit);
            if (mayBeThousands) {
                (isComma ? hasCommas : hasPoints) = true;
            } else if (isPoint || !commasSeparate) {
                return isPoint ? DecimalSign::Point : DecimalSign::Comma;
            } else {
                isSurelyComma = true;
            }
        }
    }
    const bool isComma = isSurelyComma || (hasCommas && !hasPoints && !commasSeparate);
    return isComma ? DecimalSign::Comma : DecimalSign::Point;
}

/// Takes the delimiter that a spreadsheet announces in the first line, "sep=;", off the lines; else all are possible.
std::string_view takeAnnouncedDelimiter(std::vector<Line> &lines, FileLayout &layout)
{
    const std::string_view first = lines.front().text;
    const std::size_t announced =
        first.size() == 5 && equalIgnoringCase(first.substr(0, 4), "sep=") ? kDelimiters.find(first[4]) : first.npos;
    if (announced == first.npos) {
        return kDelimiters;
    }
    layout.preambleLines.push_back(lines.front().number);
    lines.erase(lines.begin());
    return kDelimiters.substr(announced, 1);
}

} // namespace

bool isBlankLine(std::string_view line)
{
    return line.find_first_not_of(" \t;,") == line.npos;
}

TableForm findTable(std::string_view text)
{
    std::vector<Line> lines = firstLines(text);
    const auto tooLong = std::ranges::find_if(lines, [](const Line &line) { return line.text.size() > kLongestLine; });
    if (tooLong != lines.end()) {
        throw ReadError{.line = tooLong->number, .fault = {ReadFault::Kind::LineTooLong}};
    }
    TableForm form;
    const std::string_view delimiters = lines.empty() ? kDelimiters : takeAnnouncedDelimiter(lines, form.layout);
    if (lines.empty()) {
        throw ReadError{.fault = {ReadFault::Kind::Empty}};
    }
    const std::optional<FirstRow> row = findFirstRow(lines, delimiters);
    const HeaderFound header = findHeader(lines, delimiters, row);
    const Line &line = lines[header.line];
    for (std::size_t i = 0; i < header.line; ++i) {
        form.layout.preambleLines.push_back(lines[i].number);
    }
    form.headerText = excerpt(line.text);
    form.layout.delimiter = row ? row->delimiter : header.names->delimiter;
    form.data = header.names ? line.below : text.substr(static_cast<std::size_t>(line.text.data() - text.data()));
    form.firstDataLine = line.number + (header.names ? 1 : 0);
    if (header.names) {
        form.layout.headerLine = line.number;
        std::ranges::transform(header.names->cells, std::back_inserter(form.headings), parseHeading);
        if (row && lines[row->line].text.starts_with('"') && row->cells.size() == form.headings.size() + 1) {
            form.headings.insert(form.headings.begin(), Heading()); // so R writes the numbers of rows
        }
        takeAnnotations(form, delimiters, row);
    } else {
        form.headings.resize(row->cells.size());
    }
    if (row) {
        std::ranges::transform(row->cells, std::back_inserter(form.cellUnits),
                               [](std::string_view cell) { return splitUnit(cell).unit; });
        takeUnits(form, form.cellUnits, lines[row->line].number);
    }
    form.cellUnits.resize(form.headings.size());
    form.fewestCells = countNeededCells(form);
    interpretHeadings(form, std::span(lines).first(header.line));
    form.layout.decimalSign = findDecimalSign(form);
    lines = firstLines(form.data);
    for (const Line &shown : std::span(lines).first(std::min(lines.size(), kPreviewRows))) {
        std::vector<std::string> &cells = form.layout.rows.emplace_back();
        std::ranges::transform(splitCells(shown.text, form.layout.delimiter), std::back_inserter(cells), excerpt);
    }
    return form;
}

} // namespace slidercrank
