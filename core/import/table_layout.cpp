// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/table_layout.h"

#include "core/import/heading_row.h"
#include "core/import/number_text.h"
#include "core/import/unit_text.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::size_t kLongestExcerpt = 40; ///< bytes of a cell that a message repeats
constexpr std::size_t kPreviewRows = 6;

/// The header is looked for in so many lines, blank ones not counted.
constexpr std::size_t kLinesLookedAt = 200;

constexpr std::string_view kDelimiters = "\t;,";

/// A line that is not blank.
struct Line {
    std::size_t number = 0; ///< from 1
    std::string_view text;
    const char *next = nullptr; ///< where the next line begins
};

bool isBlankLine(std::string_view line)
{
    return line.find_first_not_of(" \t;,") == line.npos;
}

std::vector<Line> firstLines(std::string_view text)
{
    std::vector<Line> lines;
    CellScanner scanner(text, kDelimiters.back(), 1);
    while (!scanner.atEnd() && lines.size() < kLinesLookedAt) {
        const char *const begin = scanner.position();
        Line line{scanner.line(), {}, nullptr};
        scanner.nextLine();
        line.next = scanner.position();
        line.text = {begin, static_cast<std::size_t>(line.next - begin)};
        line.text = line.text.substr(0, std::min(line.text.find_first_of("\r\n"), line.text.size()));
        if (!isBlankLine(line.text)) {
            lines.push_back(line);
        }
    }
    return lines;
}

/// The cells of one line, without empty ones at the end.
std::vector<std::string_view> cellsOf(std::string_view line, char delimiter)
{
    std::vector<std::string_view> cells;
    for (CellScanner scanner(line, delimiter, 1); scanner.hasCell();) {
        cells.push_back(scanner.cell().text);
    }
    while (!cells.empty() && cells.back().empty()) {
        cells.pop_back();
    }
    return cells;
}

bool isNumber(std::string_view cell)
{
    return !readNumber(cell, DecimalSign::Point).fault || !readNumber(cell, DecimalSign::Comma).fault;
}

/// What the rows of a table hold, and what is between the cells.
enum class RowForm { Numbers, NumbersWithUnits, NumbersBetweenSpaces };

/// Whether all cells of the line are numbers or gaps, and two at least numbers.
bool isDataLine(std::string_view line, char delimiter, RowForm form)
{
    const std::vector<std::string_view> cells = cellsOf(line, delimiter);
    const auto number = [form](std::string_view cell) {
        const std::optional<NumberWithUnit> parts =
            form == RowForm::NumbersWithUnits ? numberWithUnit(cell) : std::nullopt;
        return parts ? parts->number : cell;
    };
    const auto filled = std::ranges::count_if(cells, looksNumeric, number);
    return filled >= 2 && std::ranges::all_of(cells, isNumber, number);
}

/// How a table is written; where nothing else is a table's row, spaces may separate the cells.
struct Form {
    RowForm rows = RowForm::Numbers;
    std::string_view delimiters; ///< that are possible
    std::size_t width = 0;       ///< cells in a row, where spaces separate them
};

Form formOf(const std::vector<Line> &lines, std::string_view delimiters)
{
    for (const RowForm rows : {RowForm::Numbers, RowForm::NumbersWithUnits}) {
        for (const Line &line : lines) {
            if (std::ranges::any_of(delimiters, [&](char each) { return isDataLine(line.text, each, rows); })) {
                return {rows, delimiters};
            }
        }
    }
    constexpr std::string_view kSpace = " ";
    for (const Line &line : lines) {
        if (delimiters == kDelimiters && isDataLine(line.text, kSpace[0], RowForm::NumbersBetweenSpaces)) {
            return {RowForm::NumbersBetweenSpaces, kSpace, cellsOf(line.text, kSpace[0]).size()};
        }
    }
    return {RowForm::Numbers, delimiters};
}

/// How many cells the first row of numbers has.
struct RowWidth {
    std::size_t filled = 0; ///< up to the last that is not empty
    std::size_t all = 0;
};

std::optional<RowWidth> widthOfRows(const std::vector<Line> &lines, const Form &form)
{
    for (const Line &line : lines) {
        for (const char delimiter : form.delimiters) {
            if (!isDataLine(line.text, delimiter, form.rows)) {
                continue;
            }
            RowWidth width{cellsOf(line.text, delimiter).size(), 0};
            for (CellScanner scanner(line.text, delimiter, 1); scanner.hasCell(); scanner.cell()) {
                ++width.all;
            }
            return width;
        }
    }
    return std::nullopt;
}

/// Without the mark of a comment that programs put before the names; not where it is the name of a column.
std::string_view withoutMark(std::string_view line)
{
    const std::string_view text = trimmed(line);
    for (const std::string_view mark : {"#", "%", "//"}) {
        if (!text.starts_with(mark)) {
            continue;
        }
        const std::size_t end = text.find_first_not_of(mark[0]);
        if (end != text.npos && kDelimiters.find(text[end]) == kDelimiters.npos) {
            return trimmed(text.substr(end));
        }
    }
    return line;
}

/// The cells between runs of two spaces at least.
std::vector<std::string_view> betweenWideSpaces(std::string_view line)
{
    std::vector<std::string_view> cells;
    for (line = trimmed(line); !line.empty();) {
        const std::size_t end = std::min(line.find("  "), line.size());
        cells.push_back(trimmed(line.substr(0, end)));
        line = trimmed(line.substr(end));
    }
    return cells;
}

/// The cells between spaces, units in brackets with their names: "Time (s)", "P[X] ( mm )".
std::vector<std::string_view> betweenSpacesOutsideBrackets(std::string_view line)
{
    std::vector<std::string_view> cells;
    const char *const end = line.data() + line.size();
    for (const char *next = line.data(); next != end;) {
        const char *const begin = next;
        int depth = 0;
        for (; next != end && (depth > 0 || !isBlank(*next)); ++next) {
            depth += *next == '(' || *next == '[' ? 1 : *next == ')' || *next == ']' ? -1 : 0;
        }
        if (next == begin) {
            ++next;
        } else if (!cells.empty() && (*begin == '(' || *begin == '[')) {
            cells.back() = {cells.back().data(), static_cast<std::size_t>(next - cells.back().data())};
        } else {
            cells.emplace_back(begin, static_cast<std::size_t>(next - begin));
        }
    }
    return cells;
}

/// The cells of a line of names, or of units. Above rows between spaces they may stand apart otherwise, and hold spaces
/// themselves: so many are wanted.
std::vector<std::string_view> namesIn(std::string_view line, char delimiter, std::size_t width)
{
    if (width == 0) {
        return cellsOf(withoutMark(line), delimiter);
    }
    for (const std::string_view text : {withoutMark(line), line}) {
        for (const char each : {'\t', ';', ',', delimiter}) {
            if (std::vector<std::string_view> cells = cellsOf(text, each); cells.size() == width) {
                return cells;
            }
        }
        for (const auto &split : {betweenWideSpaces, betweenSpacesOutsideBrackets}) {
            if (std::vector<std::string_view> cells = split(text); cells.size() == width) {
                return cells;
            }
        }
    }
    return cellsOf(withoutMark(line), delimiter);
}

// ---- header --------------------------------------------------------------------------------------------------------

/// How much a line looks like the names of a table's columns.
struct HeaderScore {
    std::size_t times = 0;
    std::size_t quantities = 0;
    std::size_t cells = 0;
    bool fits = true; ///< the rows, where their width is known

    bool complete() const { return times > 0 && quantities > 0 && fits; }
    std::size_t known() const { return times + quantities; }
};

/// `rows`: of numbers, where there are any.
HeaderScore scoreOf(std::string_view line, char delimiter, std::size_t width, const std::optional<RowWidth> &rows)
{
    HeaderScore score;
    const std::vector<std::string_view> names = namesIn(line, delimiter, width);
    score.fits = width == 0 || names.size() == width;
    const bool isMarked = withoutMark(line).size() != line.size();
    if (isMarked && width == 0 && rows && (names.size() < rows->filled || names.size() > rows->all)) {
        return {}; // a remark
    }
    for (const std::string_view cell : names) {
        ++score.cells;
        if (looksNumeric(cell)) {
            continue;
        }
        switch (meaningOf(headingOf(cell)).kind) {
        case NameMeaning::Kind::Time: ++score.times; break;
        case NameMeaning::Kind::Channel:
        case NameMeaning::Kind::Quantity: ++score.quantities; break;
        case NameMeaning::Kind::RowNumber:
        case NameMeaning::Kind::Nothing: break;
        }
    }
    return score;
}

struct HeaderFound {
    std::size_t line = 0; ///< index among the first lines
    char delimiter = kDelimiters.back();
    bool hasNames = true; ///< false: the line holds numbers already
};

/// The first line that names a time and a quantity; else the one that names most of either before the numbers; else the
/// line right above the numbers; else, where there are none, the first.
HeaderFound findHeader(const std::vector<Line> &lines, const Form &form)
{
    std::optional<HeaderFound> firstData;
    HeaderFound best;
    HeaderScore bestScore;
    const std::optional<RowWidth> rows = widthOfRows(lines, form);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        HeaderScore ofLine;
        char delimiterOfLine = form.delimiters.back();
        for (const char delimiter : form.delimiters) {
            if (!firstData && isDataLine(lines[i].text, delimiter, form.rows)) {
                firstData = HeaderFound{i, delimiter, false};
            }
            const HeaderScore score = scoreOf(lines[i].text, delimiter, form.width, rows);
            if (std::pair(score.known(), score.cells) > std::pair(ofLine.known(), ofLine.cells)) {
                ofLine = score;
                delimiterOfLine = delimiter;
            }
        }
        if (ofLine.complete()) {
            return {i, delimiterOfLine, true};
        }
        if (!firstData && (i == 0 || ofLine.known() > bestScore.known())) {
            best = {i, delimiterOfLine, true};
            bestScore = ofLine;
        }
    }
    if (bestScore.known() > 0 || !firstData) {
        return best;
    }
    const std::size_t width = cellsOf(lines[firstData->line].text, firstData->delimiter).size();
    for (std::size_t i = firstData->line; i-- > 0;) {
        const std::vector<std::string_view> cells = namesIn(lines[i].text, firstData->delimiter, form.width);
        const bool units = std::all_of(cells.begin(), cells.end(),
                                       [](std::string_view cell) { return cell.empty() || unitOf(cell).has_value(); });
        const bool mayBeNames = cells.size() == width && !units;
        if (form.width > 0 && !units && (!mayBeNames || std::ranges::any_of(cells, looksNumeric))) {
            break; // "# columns: 2": words are between spaces everywhere
        }
        if (mayBeNames) {
            return {i, firstData->delimiter, true};
        }
    }
    return *firstData;
}

// ---- units ---------------------------------------------------------------------------------------------------------

std::string_view withoutBrackets(std::string_view cell)
{
    const bool bracketed = cell.size() >= 2 &&
                           ((cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')'));
    return bracketed ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

bool isWord(std::string_view text)
{
    return !text.empty() && std::all_of(text.begin(), text.end(),
                                        [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
}

/// Where "Word:" stands first in the text, and what follows it up to the next such word.
struct Entry {
    std::string_view key;
    std::string_view value;
    std::string_view rest;
};

std::optional<Entry> entryOf(std::string_view cell)
{
    const std::size_t colon = cell.find(':');
    Entry entry;
    entry.key = trimmed(cell.substr(0, std::min(colon, cell.size())));
    if (colon == cell.npos || !isWord(entry.key.substr(0, entry.key.find(' ')))) {
        return std::nullopt;
    }
    entry.value = cell.substr(colon + 1);
    const std::size_t nextColon = entry.value.find(':');
    if (nextColon != entry.value.npos) {
        const std::size_t space = entry.value.substr(0, nextColon).find_last_of(" \t");
        if (space != entry.value.npos) {
            entry.rest = trimmed(entry.value.substr(space));
            entry.value = entry.value.substr(0, space);
        }
    }
    entry.value = trimmed(entry.value);
    while (!entry.value.empty() && (entry.value.back() == ',' || entry.value.back() == ';')) {
        entry.value.remove_suffix(1);
    }
    return entry;
}

/// What Simulink's data inspector writes below the names, "Type: double Unit: rad": the unit, if it is among it.
std::string_view unitEntry(std::string_view cell)
{
    for (std::optional<Entry> entry = entryOf(cell); entry; entry = entryOf(entry->rest)) {
        if (equalIgnoringCase(entry->key, "unit") || equalIgnoringCase(entry->key, "units")) {
            return entry->value;
        }
    }
    return {};
}

/// What a line below the header says of the columns; nothing where it is a line of data.
std::optional<std::vector<std::string_view>> annotationsOf(const std::vector<std::string_view> &cells)
{
    std::size_t filled = 0;
    std::size_t units = 0;
    std::size_t entries = 0;
    for (const std::string_view cell : cells) {
        const bool dimensionless = cell == "-" || withoutBrackets(cell) == "-";
        filled += cell.empty() || dimensionless ? 0 : 1;
        units += unitOf(withoutBrackets(cell)) ? 1 : 0;
        entries += entryOf(cell) ? 1 : 0;
        if (looksNumeric(cell)) {
            return std::nullopt;
        }
    }
    if (filled == 0) {
        return std::nullopt;
    }
    std::vector<std::string_view> annotations(cells.size());
    if (entries == filled) {
        std::transform(cells.begin(), cells.end(), annotations.begin(), unitEntry);
        return annotations;
    }
    if (units == 0 || 2 * units < filled) {
        return std::nullopt;
    }
    std::transform(cells.begin(), cells.end(), annotations.begin(), withoutBrackets);
    for (std::string_view &unit : annotations) {
        unit = unit == "-" ? std::string_view() : unit;
    }
    return annotations;
}

/// What a line, or a cell, says of the unit of a column.
std::optional<ReadError> takeUnit(Heading &heading, std::string_view unit, std::size_t line, std::size_t column)
{
    if (unit.empty()) {
        return std::nullopt;
    }
    if (!heading.unit.empty() && unitOf(heading.unit) != unitOf(unit)) {
        ReadFault fault{ReadFault::Kind::UnitsContradict};
        fault.heading = excerpt(heading.printed);
        return ReadError{line, column + 1, excerpt(unit), std::move(fault)};
    }
    heading.unit = unit;
    return std::nullopt;
}

/// Takes the lines of units and of other annotations that follow the header into the table.
std::optional<ReadError> takeAnnotations(Table &table, std::string_view text, const Form &form)
{
    const std::size_t linesAbove = table.firstDataLine - 1;
    const auto cellsIn = [&](const Line &line) { return namesIn(line.text, table.layout.delimiter, form.width); };
    const std::vector<Line> lines = firstLines(table.data);
    for (std::size_t below = 0; below < lines.size(); ++below) {
        const Line &line = lines[below];
        const std::vector<std::string_view> cells = cellsIn(line);
        const std::optional<std::vector<std::string_view>> units = annotationsOf(cells);
        const bool areOtherNames = !units && below == 0 && cells.size() == table.headings.size() &&
                                   std::ranges::none_of(cells, looksNumeric) && lines.size() > 1 &&
                                   annotationsOf(cellsIn(lines[1]));
        if (areOtherNames) {
            continue; // short ones, above the units
        }
        if (!units) {
            break;
        }
        const std::size_t number = linesAbove + line.number;
        for (std::size_t i = 0; i < std::min(units->size(), table.headings.size()); ++i) {
            if (std::optional<ReadError> error = takeUnit(table.headings[i], (*units)[i], number, i)) {
                return error;
            }
            if (!(*units)[i].empty()) {
                table.layout.unitsLine = number;
            }
        }
        table.data = text.substr(static_cast<std::size_t>(line.next - text.data()));
        table.firstDataLine = number + 1;
    }
    return std::nullopt;
}

/// Takes the units that stand in the cells themselves, by the first row, into the table.
std::optional<ReadError> takeCellUnits(Table &table)
{
    for (const Line &line : firstLines(table.data)) {
        if (!isDataLine(line.text, table.layout.delimiter, RowForm::NumbersWithUnits)) {
            continue;
        }
        const std::vector<std::string_view> cells = cellsOf(line.text, table.layout.delimiter);
        for (std::size_t i = 0; i < std::min(cells.size(), table.headings.size()); ++i) {
            if (const std::optional<NumberWithUnit> parts = numberWithUnit(cells[i])) {
                table.cellUnits[i] = parts->unit;
            }
            const std::size_t number = table.firstDataLine - 1 + line.number;
            if (std::optional<ReadError> error = takeUnit(table.headings[i], table.cellUnits[i], number, i)) {
                return error;
            }
        }
        break;
    }
    return std::nullopt;
}

/// "inDegrees=no", "Units are S.I. units (second, meters, …)": what OpenSim writes above the names.
void takeUnitsAbove(Table &table, std::span<const Line> above)
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
    if (takeUnits(table.headings, ofLengths, ofAngles)) {
        table.layout.unitsLine = line;
    }
}

/// Whether the rows begin with their numbers in quotation marks, and no name stands above: so R writes tables.
bool haveNumbersWithoutName(const Table &table)
{
    const std::vector<Line> rows = firstLines(table.data);
    return rows.size() >= 2 && std::all_of(rows.begin(), rows.begin() + 2, [&](const Line &row) {
               const std::vector<std::string_view> cells = cellsOf(row.text, table.layout.delimiter);
               return row.text.starts_with('"') && cells.size() == table.headings.size() + 1 && looksNumeric(cells[0]);
           });
}

// ---- decimals ------------------------------------------------------------------------------------------------------

/// The decimal sign of a file. The first number that can be read in one way only decides: 0,005 and 74,5436 hold a
/// decimal comma; 74,543 alone could be thousands. Where commas separate the cells as well, a decimal comma stands in
/// quoted cells only, and in no file beside decimal points.
DecimalSign findDecimalSign(const Table &table)
{
    CellScanner rows = rowsOf(table);
    const bool commasSeparate = table.layout.delimiter == ',';
    bool surelyComma = false;
    bool commas = false;
    bool points = false;
    for (; !rows.atEnd(); rows.nextLine()) {
        for (std::size_t i = 0; rows.hasCell(); ++i) {
            const std::string_view cell = rows.cell().text;
            const std::string_view text = i < table.cellUnits.size() ? withoutUnit(cell, table.cellUnits[i]) : cell;
            const std::size_t sign = text.find_first_of(".,");
            if (sign == std::string_view::npos || !looksNumeric(text) ||
                text.find_first_of(".,", sign + 1) != std::string_view::npos) {
                continue;
            }
            const std::size_t firstDigit = text.find_first_of("0123456789");
            const std::size_t fraction = text.find_first_not_of("0123456789", sign + 1);
            const std::size_t fractionDigits = std::min(fraction, text.size()) - sign - 1;
            const bool couldBeThousands = fractionDigits == 3 && fraction == std::string_view::npos &&
                                          firstDigit < sign && text[firstDigit] != '0' && sign - firstDigit <= 3;
            const bool comma = text[sign] == ',';
            if (couldBeThousands) {
                (comma ? commas : points) = true;
            } else if (!comma) {
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

std::vector<std::vector<std::string>> previewOf(const Table &table)
{
    std::vector<std::vector<std::string>> rows;
    const std::string_view begin = table.data.substr(0, std::min<std::size_t>(table.data.size(), 1U << 16U));
    for (const Line &line : firstLines(begin)) {
        if (rows.size() == kPreviewRows) {
            break;
        }
        std::vector<std::string> row;
        for (const std::string_view cell : cellsOf(line.text, table.layout.delimiter)) {
            row.push_back(excerpt(cell));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace

std::string excerpt(std::string_view text)
{
    if (text.size() <= kLongestExcerpt) {
        return std::string(text);
    }
    std::size_t length = kLongestExcerpt;
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
        --length;
    }
    return std::string(text.substr(0, length)) + "…";
}

CellScanner rowsOf(const Table &table)
{
    return CellScanner(table.data, table.layout.delimiter, table.firstDataLine);
}

std::variant<Table, ReadError> findTable(std::string_view text)
{
    std::vector<Line> lines = firstLines(text);
    Table table;
    std::string_view delimiters = kDelimiters;
    constexpr std::string_view kSeparatorHint = "sep="; // spreadsheets may write their delimiter so, in a first line
    if (!lines.empty()) {
        const std::string_view first = lines.front().text;
        const std::size_t announced =
            first.size() == kSeparatorHint.size() + 1 ? kDelimiters.find(first.back()) : first.npos;
        if (announced != first.npos && equalIgnoringCase(first.substr(0, kSeparatorHint.size()), kSeparatorHint)) {
            delimiters = kDelimiters.substr(announced, 1);
            table.layout.preambleLines.push_back(lines.front().number);
            lines.erase(lines.begin());
        }
    }
    if (lines.empty()) {
        return ReadError{0, 0, {}, {ReadFault::Kind::Empty}};
    }

    const Form form = formOf(lines, delimiters);
    const HeaderFound found = findHeader(lines, form);
    const Line &line = lines[found.line];
    for (std::size_t i = 0; i < found.line; ++i) {
        table.layout.preambleLines.push_back(lines[i].number);
    }
    table.layout.delimiter = found.delimiter;
    table.headerText = excerpt(line.text);
    const std::vector<std::string_view> names =
        found.hasNames ? namesIn(line.text, found.delimiter, form.width) : cellsOf(line.text, found.delimiter);
    for (const std::string_view cell : names) {
        table.headings.push_back(found.hasNames ? headingOf(cell) : Heading());
    }
    const char *const dataBegin = found.hasNames ? line.next : line.text.data();
    table.data = text.substr(static_cast<std::size_t>(dataBegin - text.data()));
    if (found.hasNames && haveNumbersWithoutName(table)) {
        table.headings.insert(table.headings.begin(), Heading());
    }
    table.cellUnits.resize(table.headings.size());
    table.firstDataLine = found.hasNames ? line.number + 1 : line.number;
    if (found.hasNames) {
        table.layout.headerLine = line.number;
        if (std::optional<ReadError> error = takeAnnotations(table, text, form)) {
            return *std::move(error);
        }
    }
    if (form.rows == RowForm::NumbersWithUnits) {
        if (std::optional<ReadError> error = takeCellUnits(table)) {
            return *std::move(error);
        }
    }
    takeUnitsAbove(table, std::span(lines).first(found.line));
    readTogether(table.headings);
    table.layout.decimalSign = findDecimalSign(table);
    for (const Heading &heading : table.headings) {
        FileColumn column;
        column.heading = heading.printed;
        column.unit = heading.unit;
        table.layout.columns.push_back(std::move(column));
    }
    table.layout.rows = previewOf(table);
    return table;
}

} // namespace slidercrank
