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

// ---- rows ----------------------------------------------------------------------------------------------------------

/// The first row of numbers.
struct FirstRow {
    std::size_t line = 0; ///< index among the first lines
    char delimiter = ',';
    std::size_t filled = 0; ///< cells, without empty ones at the end
    std::size_t cells = 0;

    bool isBySpaces() const { return delimiter == ' '; }
    bool fits(const Cells &names) const { return names.size() >= filled && names.size() <= cells; }
};

/// Whether all cells of the line are numbers, perhaps with units, or gaps, and two at least numbers.
bool isRow(const Cells &cells)
{
    std::size_t filled = 0;
    return std::ranges::all_of(cells,
                               [&filled](std::string_view cell) {
                                   const std::optional<NumberWithUnit> parts = splitUnit(cell);
                                   const std::string_view number = parts ? parts->number : cell;
                                   filled += looksNumeric(number) ? 1 : 0;
                                   return !parseNumber(number, DecimalSign::Point).fault ||
                                          !parseNumber(number, DecimalSign::Comma).fault;
                               }) &&
           filled >= 2;
}

/// Spaces separate the cells only where no other delimiter makes a row of any line.
std::optional<FirstRow> findFirstRow(std::span<const Line> lines, std::string_view delimiters)
{
    for (const std::string_view tried : {delimiters, std::string_view(delimiters == kDelimiters ? " " : "")}) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            for (const char delimiter : tried) {
                const Cells cells = splitCells(lines[i].text, delimiter);
                if (!isRow(cells)) {
                    continue;
                }
                FirstRow row{i, delimiter, cells.size()};
                for (CellReader reader(lines[i].text, delimiter); reader.hasCell(); reader.next()) {
                    ++row.cells;
                }
                return row;
            }
        }
    }
    return std::nullopt;
}

// ---- names ---------------------------------------------------------------------------------------------------------

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
    Cells cells;
    char delimiter = kDelimiters.back();
    std::size_t times = 0;
    std::size_t quantities = 0;
    bool fits = true; ///< the first row, where spaces separate its cells

    std::size_t known() const { return times + quantities; }
    bool isComplete() const { return times > 0 && quantities > 0 && fits; }
};

Names makeNames(Cells cells, char delimiter)
{
    Names names{std::move(cells), delimiter};
    for (const std::string_view cell : names.cells) {
        const NameMeaning::Kind kind =
            looksNumeric(cell) ? NameMeaning::Kind::Nothing : meaningOf(parseHeading(cell)).kind;
        names.times += kind == NameMeaning::Kind::Time ? 1 : 0;
        names.quantities += kind == NameMeaning::Kind::Channel || kind == NameMeaning::Kind::Quantity ? 1 : 0;
    }
    return names;
}

/// The reading of the line that recognizes most names. Above rows between spaces, or behind the mark of a comment,
/// names may be separated otherwise than the numbers; then there have to be as many.
Names readNames(std::string_view line, std::string_view delimiters, const std::optional<FirstRow> &row)
{
    const std::string_view text = withoutMark(line);
    const bool isMarked = text.size() != line.size();
    Names best;
    const auto offer = [&](Names names) {
        const bool isMore = std::pair(names.known(), names.cells.size()) > std::pair(best.known(), best.cells.size());
        best = isMore || best.cells.empty() ? std::move(names) : best;
    };
    for (const char delimiter : delimiters) {
        Names names = makeNames(splitCells(text, delimiter), delimiter);
        const bool mayBe = !row || (row->isBySpaces() || isMarked ? row->fits(names.cells) : true);
        if (mayBe) {
            offer(std::move(names));
        }
    }
    if (!row || (!row->isBySpaces() && !isMarked)) {
        return best;
    }
    for (Cells cells : {splitCells(text, ' '), splitBetweenBlanks(text, 2), splitBetweenBlanks(text, 1)}) {
        Names names = row->fits(cells) ? makeNames(std::move(cells), row->delimiter) : Names();
        if (row->isBySpaces() ? !names.cells.empty() : names.isComplete() && names.known() + 1 >= names.cells.size()) {
            offer(std::move(names)); // else a remark
        }
    }
    if (best.cells.empty() && row->isBySpaces()) {
        best = makeNames(splitCells(text, ' '), ' ');
        best.fits = false;
    }
    return best;
}

struct HeaderFound {
    std::size_t line = 0;       ///< index among the first lines
    std::optional<Names> names; ///< none: the line holds numbers already
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
        if (names.cells.size() == row->filled && std::ranges::none_of(names.cells, looksNumeric)) {
            return {i, std::move(names)};
        }
        break;
    }
    return {row->line, std::nullopt};
}

/// Whether the rows begin with their numbers in quotation marks, and no name stands above: so R writes tables.
bool haveNumbersWithoutName(const TableForm &form)
{
    const std::vector<Line> rows = firstLines(form.data);
    return rows.size() >= 2 && std::all_of(rows.begin(), rows.begin() + 2, [&](const Line &row) {
               const Cells cells = splitCells(row.text, form.layout.delimiter);
               return row.text.starts_with('"') && cells.size() == form.headings.size() + 1 && looksNumeric(cells[0]);
           });
}

/// How many cells a row needs: all that have a heading, or as many as the longest of the first rows has where the names
/// behind mean nothing.
std::size_t countNeededCells(const TableForm &form)
{
    std::size_t most = 0;
    for (const Line &row : firstLines(form.data)) {
        most = std::max(most, splitCells(row.text, form.layout.delimiter).size());
    }
    const std::size_t all = form.headings.size();
    const bool isSpare =
        most >= 2 && most < all &&
        std::all_of(form.headings.begin() + static_cast<std::ptrdiff_t>(most), form.headings.end(),
                    [](const Heading &heading) { return meaningOf(heading).kind == NameMeaning::Kind::Nothing; });
    return isSpare ? most : all;
}

// ---- units ---------------------------------------------------------------------------------------------------------

/// What a cell below the names says of its column: "[mm]", "-" and "Type: double Unit: rad", as Simulink's data
/// inspector writes it. Nothing where it says nothing of this kind; an empty text where it gives no unit.
std::optional<std::string_view> readAnnotation(std::string_view cell)
{
    const bool isBracketed =
        (cell.starts_with('[') && cell.ends_with(']')) || (cell.starts_with('(') && cell.ends_with(')'));
    const std::string_view unit = isBracketed ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
    if (parseUnit(unit)) {
        return unit;
    }
    constexpr std::string_view kUnit = "Unit:";
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
    std::size_t filled = 0;
    Cells units;
    std::size_t found = 0;
    for (const std::string_view cell : cells) {
        const std::optional<std::string_view> unit = readAnnotation(cell);
        filled += cell.empty() ? 0 : 1;
        found += unit ? 1 : 0;
        units.push_back(unit.value_or(""));
    }
    const bool isData = found == 0 || 2 * found < filled || std::ranges::any_of(cells, looksNumeric);
    return isData ? std::nullopt : std::optional(std::move(units));
}

std::optional<ReadError> takeUnit(TableForm &form, std::size_t column, std::string_view unit, std::size_t line)
{
    Heading &heading = form.headings[column];
    if (unit.empty()) {
        return std::nullopt;
    }
    if (!heading.unit.empty() && parseUnit(heading.unit) != parseUnit(unit)) {
        ReadFault fault{ReadFault::Kind::UnitsContradict};
        fault.heading = excerpt(heading.printed);
        return ReadError{line, column + 1, excerpt(unit), std::move(fault)};
    }
    heading.unit = unit;
    return std::nullopt;
}

/// Takes the lines of units and of other annotations below the names.
std::optional<ReadError> takeAnnotations(TableForm &form, std::string_view delimiters,
                                         const std::optional<FirstRow> &row)
{
    const std::vector<Line> lines = firstLines(form.data, form.firstDataLine);
    const auto cellsIn = [&](const Line &line) {
        return row && row->isBySpaces() ? readNames(line.text, delimiters, row).cells
                                        : splitCells(line.text, form.layout.delimiter);
    };
    for (std::size_t below = 0; below < lines.size(); ++below) {
        const Cells cells = cellsIn(lines[below]);
        const std::optional<Cells> units = readAnnotations(cells);
        const bool areOtherNames = !units && below == 0 && cells.size() == form.headings.size() &&
                                   std::ranges::none_of(cells, looksNumeric) && lines.size() > 1 &&
                                   readAnnotations(cellsIn(lines[1]));
        if (areOtherNames) {
            continue; // short ones, above the units
        }
        if (!units) {
            break;
        }
        const std::size_t number = lines[below].number;
        for (std::size_t i = 0; i < std::min(units->size(), form.headings.size()); ++i) {
            if (std::optional<ReadError> error = takeUnit(form, i, (*units)[i], number)) {
                return error;
            }
            form.layout.unitsLine = (*units)[i].empty() ? form.layout.unitsLine : number;
        }
        form.data = lines[below].below;
        form.firstDataLine = number + 1;
    }
    return std::nullopt;
}

/// Takes the units that stand in the cells themselves, by the first row.
std::optional<ReadError> takeCellUnits(TableForm &form, const Line &row)
{
    const Cells cells = splitCells(row.text, form.layout.delimiter);
    for (std::size_t i = 0; i < std::min(cells.size(), form.headings.size()); ++i) {
        const std::optional<NumberWithUnit> parts = splitUnit(cells[i]);
        form.cellUnits[i] = parts ? parts->unit : "";
        if (std::optional<ReadError> error = takeUnit(form, i, form.cellUnits[i], row.number)) {
            return error;
        }
    }
    return std::nullopt;
}

/// "inDegrees=no", "Units are S.I. units (second, meters, …)": what OpenSim writes above the names.
void takeUnitsAbove(TableForm &form, std::span<const Line> above)
{
    std::string_view ofLengths;
    std::string_view ofAngles;
    std::size_t line = 0;
    for (const Line &each : above) {
        const std::string_view text = trimmed(each.text);
        if (text == "inDegrees=yes" || text == "inDegrees=no") {
            ofAngles = text.ends_with("yes") ? "deg" : "rad";
        } else if (text.starts_with("Units are S.I. units")) {
            ofLengths = "m";
        } else {
            continue;
        }
        line = line == 0 ? each.number : line;
    }
    if (giveUnits(form.headings, ofLengths, ofAngles)) {
        form.layout.unitsLine = line;
    }
}

// ---- decimals ------------------------------------------------------------------------------------------------------

/// The decimal sign of a file. The first number that can be read in one way only decides: 0,005 and 74,5436 and 1.234,5
/// hold a decimal comma; 74,543 alone could be thousands. Where commas separate the cells as well, a decimal comma
/// stands in quoted cells only, and in no file beside decimal points.
DecimalSign findDecimalSign(const TableForm &form)
{
    const bool commasSeparate = form.layout.delimiter == ',';
    if (form.data.find(',') == form.data.npos || (commasSeparate && form.data.find('"') == form.data.npos)) {
        return DecimalSign::Point;
    }
    bool surelyComma = false;
    bool commas = false;
    bool points = false;
    for (std::string_view rest = form.data; !rest.empty();) {
        for (const std::string_view cell : splitCells(takeLine(rest), form.layout.delimiter)) {
            const std::optional<NumberWithUnit> parts = splitUnit(cell);
            const std::string_view text = parts ? parts->number : cell;
            if (text.find_first_of(".,") == text.npos || !looksNumeric(text)) {
                continue;
            }
            const bool isPoint = !parseNumber(text, DecimalSign::Point).fault;
            const bool isComma = !parseNumber(text, DecimalSign::Comma).fault;
            const std::size_t sign = text.find_first_of(".,");
            const std::size_t first = text.find_first_of("0123456789");
            const bool mayBeThousands = text.size() == sign + 4 && first < sign && sign - first <= 3 &&
                                        text[first] != '0' && std::ranges::all_of(text.substr(sign + 1), isDigit);
            if (isPoint == isComma) {
                continue;
            }
            if (mayBeThousands) {
                (isComma ? commas : points) = true;
            } else if (isPoint) {
                return DecimalSign::Point;
            } else if (!commasSeparate) {
                return DecimalSign::Comma;
            } else {
                surelyComma = true;
            }
        }
    }
    return surelyComma || (commas && !points && !commasSeparate) ? DecimalSign::Comma : DecimalSign::Point;
}

// ---- the table -----------------------------------------------------------------------------------------------------

/// Takes the delimiter that a spreadsheet announces in the first line, "sep=;", off the lines; else all are possible.
std::string_view takeAnnouncedDelimiter(std::vector<Line> &lines, FileLayout &layout)
{
    constexpr std::string_view kAnnouncement = "sep=";
    const std::string_view first = lines.front().text;
    const std::size_t announced =
        first.size() == kAnnouncement.size() + 1 ? kDelimiters.find(first.back()) : first.npos;
    if (announced == first.npos || !equalIgnoringCase(first.substr(0, kAnnouncement.size()), kAnnouncement)) {
        return kDelimiters;
    }
    layout.preambleLines.push_back(lines.front().number);
    lines.erase(lines.begin());
    return kDelimiters.substr(announced, 1);
}

/// The parts of the layout that show a person what the file looks like.
void describe(TableForm &form)
{
    for (const Heading &heading : form.headings) {
        FileColumn column;
        column.heading = heading.printed;
        column.unit = heading.unit;
        form.layout.columns.push_back(std::move(column));
    }
    for (const Line &line : firstLines(form.data)) {
        if (form.layout.rows.size() == kPreviewRows) {
            break;
        }
        std::vector<std::string> &row = form.layout.rows.emplace_back();
        for (const std::string_view cell : splitCells(line.text, form.layout.delimiter)) {
            row.push_back(excerpt(cell));
        }
    }
}

} // namespace

bool isBlankLine(std::string_view line)
{
    return line.find_first_not_of(" \t;,") == line.npos;
}

std::variant<TableForm, ReadError> findTable(std::string_view text)
{
    std::vector<Line> lines = firstLines(text);
    const auto tooLong = std::ranges::find_if(lines, [](const Line &line) { return line.text.size() > kLongestLine; });
    if (tooLong != lines.end()) {
        return ReadError{tooLong->number, 0, {}, {ReadFault::Kind::LineTooLong}};
    }
    TableForm form;
    const std::string_view delimiters = lines.empty() ? kDelimiters : takeAnnouncedDelimiter(lines, form.layout);
    if (lines.empty()) {
        return ReadError{0, 0, {}, {ReadFault::Kind::Empty}};
    }
    const std::optional<FirstRow> row = findFirstRow(lines, delimiters);
    const HeaderFound header = findHeader(lines, delimiters, row);
    const Line &line = lines[header.line];
    for (std::size_t i = 0; i < header.line; ++i) {
        form.layout.preambleLines.push_back(lines[i].number);
    }
    form.headerText = excerpt(line.text);
    form.layout.delimiter = row ? row->delimiter : header.names ? header.names->delimiter : delimiters.back();
    form.data = header.names ? line.below : text.substr(static_cast<std::size_t>(line.text.data() - text.data()));
    form.firstDataLine = line.number + (header.names ? 1 : 0);
    form.headings.resize(header.names ? 0 : row->filled);
    for (const std::string_view cell : header.names ? header.names->cells : Cells()) {
        form.headings.push_back(parseHeading(cell));
    }
    if (header.names) {
        form.layout.headerLine = line.number;
        if (haveNumbersWithoutName(form)) {
            form.headings.insert(form.headings.begin(), Heading());
        }
        if (std::optional<ReadError> error = takeAnnotations(form, delimiters, row)) {
            return *std::move(error);
        }
    }
    form.cellUnits.resize(form.headings.size());
    if (std::optional<ReadError> error = row ? takeCellUnits(form, lines[row->line]) : std::nullopt) {
        return *std::move(error);
    }
    form.fewestCells = countNeededCells(form);
    takeUnitsAbove(form, std::span(lines).first(header.line));
    relateHeadings(form.headings);
    form.layout.decimalSign = findDecimalSign(form);
    describe(form);
    return form;
}

} // namespace slidercrank
