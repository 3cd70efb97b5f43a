// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/table_form.h"

#include "core/import/crank_angles.h"
#include "core/import/reference_data.h"
#include "core/import/vocabulary.h"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = NameMeaning::Kind;

constexpr std::string_view kDelimiters = "\t;,|&";

using Lines = std::span<const Line>;

/// The lines that are examined.
Lines firstLines(Lines lines)
{
    return lines.first(std::min(lines.size(), kExaminedLines));
}

/// A line that was split into cells.
struct SplitLine {
    Cells cells{}; ///< without empty ones at the end
    char delimiter = ',';
    std::size_t size = 0;       ///< number of cells of a row of numbers or of the next row, if this is longer, with
                                ///< empty ones at the end
    std::size_t line = 0;       ///< index among the first lines
    std::size_t times = 0;      ///< number of cells that name a time
    std::size_t quantities = 0; ///< number of cells that name a quantity

    std::size_t known() const { return times + quantities; }
    bool isComplete() const { return times > 0 && quantities > 0; }

    /// Returns whether these are as many headings as a row of numbers has cells, with or without empty ones at the end.
    bool fit(const std::optional<SplitLine> &row) const
    {
        return row && cells.size() >= row->cells.size() && cells.size() <= std::max(row->size, row->cells.size());
    }
};

/// Returns whether the text is a number with or without a unit.
bool isNumber(std::string_view cell)
{
    return looksNumeric(splitUnit(cell).number);
}

/// Returns whether a cell is a number, or a gap such as "-" or "NaN".
bool isNumberOrGap(std::string_view cell)
{
    const std::string_view number = splitUnit(cell).number;
    return !parseNumber(number, DecimalSign::Point).fault || !parseNumber(number, DecimalSign::Comma).fault;
}

/// Returns whether all cells are gaps or numbers, with or without units, and at least two are numbers.
bool isRow(const Cells &cells)
{
    return std::ranges::all_of(cells, isNumberOrGap) && std::ranges::count_if(cells, isNumber) >= 2;
}

/// Returns the number of cells of a line, with empty ones at the end.
std::size_t countCells(std::string_view line, char delimiter)
{
    return static_cast<std::size_t>(std::ranges::count(line, delimiter)) + 1;
}

/// Returns the number of cells of a row of numbers; 0 for another line.
std::size_t sizeOfRow(const Line &line, char delimiter)
{
    return isRow(splitCells(line.text, delimiter)) ? countCells(line.text, delimiter) : 0;
}

/// Returns the first line that is a row of numbers. Spaces only count as the delimiter if with no other one any line is
/// a row.
std::optional<SplitLine> findFirstRow(Lines lines)
{
    for (const std::string_view delimiters : {kDelimiters, std::string_view(" ")}) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            for (const char delimiter : delimiters) {
                if (Cells cells = splitCells(lines[i].text, delimiter); isRow(cells)) {
                    const std::size_t size = std::max(countCells(lines[i].text, delimiter),
                                                      i + 1 < lines.size() ? sizeOfRow(lines[i + 1], delimiter) : 0);
                    return SplitLine{std::move(cells), delimiter, delimiter == ' ' ? 0 : size, i};
                }
            }
        }
    }
    return std::nullopt;
}

/// Returns the label before the number in a cell with its mark, such as "angle:" in "angle:12.5" and "x =" in "x = 85
/// mm"; empty if there is none.
std::string_view labelOf(std::string_view cell)
{
    const std::size_t mark = cell.find_first_of(":=");
    const bool isLabelled =
        mark != cell.npos && mark > 0 && !isDigit(cell[0]) && isNumber(trimmed(cell.substr(mark + 1)));
    return isLabelled ? cell.substr(0, mark + 1) : std::string_view();
}

/// Returns the labels of all cells of a line, which stand before the number in the cell, or in the cell before it, as
/// in "x= 85" and "x = 85" between blanks. The label of a cell that is a label is the cell itself; that of others is
/// empty.
Cells labelsOf(const Line &line, char delimiter)
{
    const Cells cells = splitCells(line.text, delimiter);
    const auto isLabel = [&cells](std::size_t i) { return cells[i].ends_with('=') || cells[i].ends_with(':'); };
    Cells labels;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        std::string_view label = labelOf(cells[i]);
        const bool isBeforeMark = i + 1 < cells.size() && cells[i + 1] == "=";
        if (isNumber(cells[i]) && i > 0 && isLabel(i - 1)) {
            label = cells[i - 1] == "=" && i > 1 ? cells[i - 2] : cells[i - 1];
        } else if (!isNumber(cells[i]) && (isLabel(i) || isBeforeMark)) {
            label = cells[i];
        }
        labels.push_back(label);
    }
    return labels;
}

/// Returns the first line whose cells have the same labels before their numbers as those of the next line.
std::optional<SplitLine> findLabelledRow(Lines lines)
{
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        for (const char delimiter : std::string_view("\t;,| ")) {
            const Cells labels = labelsOf(lines[i], delimiter);
            const bool areLabels = labels.size() > 1 && std::ranges::count(labels, std::string_view()) == 0;
            if (areLabels && labels == labelsOf(lines[i + 1], delimiter)) {
                return SplitLine{.cells = labels, .delimiter = delimiter, .line = i};
            }
        }
    }
    return std::nullopt;
}

/// Returns the headings of a table whose cells contain them as labels, as the serial plotter of Arduino writes it:
/// "t:0.1,angle:12.5".
std::vector<Heading> headingsOfLabels(const SplitLine &labels, const Line &row)
{
    std::vector<Heading> headings;
    const Cells cells = splitCells(row.text, labels.delimiter);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string_view label = labels.cells[i];
        if (label == cells[i]) { // without a number
            headings.emplace_back();
            continue;
        }
        Heading &heading =
            headings.emplace_back(parseHeading(trimmed(label.substr(0, label.find_last_not_of(":=") + 1))));
        heading.cells.label = label;
        const std::string_view number = cells[i].starts_with(label) ? cells[i].substr(label.size()) : cells[i];
        heading.cells.unit = splitUnit(trimmed(number)).unit;
    }
    return headings;
}

/// Removes the comment mark that some programs write before the headings.
std::string_view withoutMark(std::string_view line)
{
    const std::string_view text = trimmed(line);
    for (const std::string_view mark : {"#", "%", "//", "!", "--", "*"}) {
        const std::size_t end = text.starts_with(mark) ? text.find_first_not_of(mark[0]) : text.npos;
        if (end != text.npos) {
            return trimmed(text.substr(end));
        }
    }
    return line;
}

/// Returns the text in brackets that fills a cell; empty if there are none.
std::string_view inBrackets(std::string_view cell)
{
    const bool isBracketed =
        cell.size() > 2 && (cell[0] == '[' || cell[0] == '(') && (cell.back() == ']' || cell.back() == ')');
    return isBracketed ? trimmed(cell.substr(1, cell.size() - 2)) : std::string_view();
}

/// Counts the cells that name a time and those that name a quantity, which units in brackets do not. Returns the counts
/// with the cells.
SplitLine countNames(Cells cells, char delimiter)
{
    SplitLine names{std::move(cells), delimiter};
    for (const std::string_view cell : names.cells) {
        const bool isName = !looksNumeric(cell) && !parseUnit(inBrackets(cell));
        const NameMeaning meaning = isName ? parseHeading(cell).meaning : NameMeaning();
        names.times += meaning.kind == Kind::Time ? 1 : 0;
        names.quantities += meaning.kind >= Kind::Quantity && !meaning.hasUnknownWords ? 1 : 0;
    }
    return names;
}

/// Returns the headings without the cells from one that begins with a comment mark, but "%time" of ROS is a heading.
std::span<const std::string_view> withoutRemark(const Cells &headings)
{
    const auto isRemark = [](std::string_view cell) {
        return (cell.starts_with('%') || cell.starts_with('#')) && parseHeading(cell).meaning.kind == Kind::Nothing;
    };
    const auto remark = std::find_if(headings.begin() + (headings.empty() ? 0 : 1), headings.end(), isRemark);
    return {headings.begin(), remark};
}

/// Returns whether a cell continues the heading in the cell before it, as the unit in "Time, s", the symbol with its
/// unit in "Position, x (mm)" and the number of the measurement in "Position (m), Run #1" do.
bool continuesHeading(std::string_view before, std::string_view cell)
{
    const Heading first = parseHeading(before);
    const Heading second = parseHeading(cell);
    const Channel channel = first.meaning.channel;
    const Channel channelOfSymbol = second.meaning.channel;
    const bool isSameQuantity =
        std::min(first.meaning.kind, Kind::Quantity) == std::min(second.meaning.kind, Kind::Quantity) &&
        isAngle(channel.coordinate) == isAngle(channelOfSymbol.coordinate) && channel.order == channelOfSymbol.order;
    const bool isSymbol = first.meaning.kind != Kind::Nothing && first.use.unit.empty() && !second.use.unit.empty() &&
                          beginsWithSymbol(second);
    return parseUnit(cell) || cell.starts_with("Run #") || (isSymbol && isSameQuantity);
}

/// Joins cells where unquoted headings contain the delimiter: "Time, s,Position, x (mm)".
Cells withHeadingsJoined(const Cells &cells)
{
    Cells joined;
    for (const std::string_view cell : cells) {
        if (!joined.empty() && continuesHeading(joined.back(), cell)) {
            joined.back() = {joined.back().data(), cell.data() + cell.size()};
        } else {
            joined.push_back(cell);
        }
    }
    return joined;
}

/// Returns the cells into which each delimiter splits a line, and the number of names among them.
std::vector<SplitLine> waysToSplit(std::string_view line, const std::optional<SplitLine> &row)
{
    std::vector<SplitLine> ways;
    for (const char delimiter : kDelimiters) {
        SplitLine names = countNames(splitCells(line, delimiter), delimiter);
        if (row && names.cells.size() > row->cells.size() && !names.fit(row)) {
            SplitLine joined = countNames(withHeadingsJoined(names.cells), delimiter);
            if (joined.fit(row)) {
                names = std::move(joined);
            }
        }
        ways.push_back(std::move(names));
    }
    for (const Cells &cells : {splitCells(line, ' '), splitAtBlanks(line, 2), splitAtBlanks(line, 1)}) {
        ways.push_back(countNames(cells, ' '));
    }
    return ways;
}

/// Returns whether names may be the headings of the row. If they are as many as the numbers, they may have any
/// delimiter; but if only the names are separated by spaces, at most one of them may be unknown. The same holds if only
/// the column of the row names has no heading. Otherwise a remark has to follow them if they stand after a comment
/// mark, and neither they nor the numbers are separated by spaces.
bool mayBeHeadings(const SplitLine &names, const std::optional<SplitLine> &row, bool isMarked)
{
    const bool areSpaced = names.delimiter == ' ';
    if (!row) {
        return !areSpaced;
    }
    const std::size_t numbers = row->cells.size();
    if (names.fit(row)) {
        return !areSpaced || row->delimiter == ' ' || (names.isComplete() && names.known() + 1 >= numbers);
    }
    if (areSpaced && names.cells.size() + 1 == numbers) {
        return names.isComplete() && names.known() == names.cells.size();
    }
    const bool hasRemark = names.isComplete() && (withoutRemark(names.cells).size() == numbers ||
                                                  (names.cells.size() > numbers && names.known() >= numbers));
    return !areSpaced && row->delimiter != ' ' && (!isMarked || hasRemark);
}

/// Splits a line into cells that may be headings. The delimiter of the row of numbers is chosen if it makes as many
/// cells, one of them a time; else the one with most known names, and of several the one with as many cells as the row.
/// A comment mark before the headings is removed, unless only the line with the mark can be split. Returns no known
/// names for a row of data and for a line that cannot be the headings.
SplitLine readNames(std::string_view line, const std::optional<SplitLine> &row)
{
    const auto rankOf = [&row](const SplitLine &names) {
        const bool hasSize = names.fit(row);
        const bool isLikeRow =
            hasSize && names.delimiter == row->delimiter && names.delimiter != ' ' && names.times > 0;
        return std::tuple(isLikeRow, names.known(), hasSize, names.cells.size());
    };
    const bool isSpaced = row && row->delimiter == ' ';
    const bool isNumberSign = row && !isSpaced && trimmed(line).starts_with(std::string("#") + row->delimiter) &&
                              countCells(line, row->delimiter) == row->size;
    const std::string_view unmarked = isNumberSign ? line : withoutMark(line); // "#,t,x" numbers the rows
    if (isData(unmarked)) {
        return isSpaced ? SplitLine{splitCells(unmarked, ' '), ' '} : SplitLine();
    }
    for (const std::string_view text : {unmarked, line}) {
        SplitLine best;
        for (SplitLine &names : waysToSplit(text, row)) {
            if (mayBeHeadings(names, row, unmarked.size() < line.size()) && rankOf(names) > rankOf(best)) {
                best = std::move(names);
            }
        }
        if (!best.cells.empty()) {
            return best;
        }
    }
    return isSpaced ? countNames(splitCells(unmarked, ' '), ' ') : SplitLine();
}

/// Returns the line with most names of times and quantities; null if no line has any. Of lines with as many names, it
/// is the last one that has as many cells as the row, or else the first one. Between blanks, at least half of the words
/// are names, unlike in a remark.
SplitLine *findMostNames(std::vector<SplitLine> &lines, const std::optional<SplitLine> &row)
{
    SplitLine *best = nullptr;
    for (SplitLine &names : lines) {
        const std::size_t known = best ? best->known() : 0;
        if (names.delimiter == ' ' && 2 * names.known() < names.cells.size()) {
            continue;
        }
        if (names.known() > known || (best && names.known() == known && names.fit(row))) {
            best = &names;
        }
    }
    return best;
}

/// Returns the last line that is no line of units, if it has as many words as the row has numbers; else nullopt.
std::optional<SplitLine> findUnknownHeadings(std::vector<SplitLine> &lines, const std::optional<SplitLine> &row)
{
    const auto isUnit = [](std::string_view cell) { return cell.empty() || parseUnit(cell); };
    const auto areUnits = [&](const SplitLine &line) { return std::ranges::all_of(line.cells, isUnit); };
    const auto last = std::find_if_not(lines.rbegin(), lines.rend(), areUnits);
    const bool areHeadings = last != lines.rend() && last->fit(row) && std::ranges::none_of(last->cells, looksNumeric);
    return areHeadings ? std::optional(std::move(*last)) : std::nullopt;
}

/// Returns the text behind the number in a line that describes a column: "time [s]" of "# Column 1: time [s]". Empty if
/// the first number in the line is a different one.
std::string_view textBehindNumber(std::string_view line, std::size_t number)
{
    const std::string digits = std::to_string(number);
    const std::string_view rest = line.substr(std::min(line.find_first_of("0123456789"), line.size()));
    const std::size_t text = rest.find_first_not_of(" \t:=.)]-", digits.size());
    return rest.starts_with(digits) && text != rest.npos && !isDigit(rest[digits.size()]) ? trimmed(rest.substr(text))
                                                                                          : std::string_view();
}

/// Returns the headings in lines that name one column each. `firstNumber` is the number of the first column, as in
/// "# Column 1: time [s]"; then at least one name is known. Without numbers, as in "# - time [s]", all names are known,
/// and the first one is the time or the crank angle. Returns nullopt for other lines.
std::optional<SplitLine> readList(Lines lines, std::optional<std::size_t> firstNumber)
{
    Cells names;
    for (const Line &line : lines) {
        const std::string_view unmarked = withoutMark(line.text);
        names.push_back(firstNumber ? textBehindNumber(line.text, *firstNumber + names.size())
                                    : unmarked.substr(std::min(unmarked.find_first_not_of("- "), unmarked.size())));
    }
    const auto isAbscissa = [](const NameMeaning &meaning) {
        return meaning.kind == Kind::Time || (meaning.kind >= Kind::Words && meaning.channel == kCrankAngle);
    };
    const bool mayBeList = firstNumber ? std::ranges::count(names, std::string_view()) == 0
                                       : isAbscissa(parseHeading(names.front()).meaning);
    SplitLine list = mayBeList ? countNames(names, ',') : SplitLine();
    return list.known() >= (firstNumber ? 1 : lines.size()) ? std::optional(std::move(list)) : std::nullopt;
}

/// Finds headings in consecutive lines above the row of numbers that name one column each. Returns nullopt if there are
/// none, or if a line of headings is below them: then they may describe anything, such as sensors or parameters.
/// SplitLine::line is the last of these lines.
std::optional<SplitLine> findListedHeadings(Lines above, const SplitLine &row)
{
    const std::size_t size = row.cells.size();
    for (std::size_t end = above.size(); end >= size; --end) {
        if (end < above.size()) {
            const SplitLine below = readNames(above[end].text, row);
            if (below.fit(row) && 2 * below.known() > below.cells.size()) {
                return std::nullopt;
            }
        }
        for (const auto firstNumber : {std::optional<std::size_t>(0), std::optional<std::size_t>(1), {}}) {
            if (std::optional<SplitLine> list = readList(above.subspan(end - size, size), firstNumber)) {
                list->line = end - 1;
                return list;
            }
        }
    }
    return std::nullopt;
}

/// Finds the line of headings:
///
/// 1. the lines above the row that name one column each,
/// 2. else the first line of all that names a time and a quantity and has as many cells as the row, with its delimiter
///    or else with another one,
/// 3. else, of the lines above the row, the one with most names,
/// 4. else, if there is no row of numbers, the first line,
/// 5. else the one directly above the numbers and their units, if it has as many cells as the row.
///
/// Returns nullopt if the file begins with the first row of numbers.
std::optional<SplitLine> findHeader(Lines lines, const std::optional<SplitLine> &row)
{
    if (auto list = row ? findListedHeadings(lines.first(row->line), *row) : std::nullopt) {
        return list;
    }
    std::vector<SplitLine> above;
    std::optional<SplitLine> otherwiseSplit; // the first line with another delimiter
    for (std::size_t i = 0; i < lines.size(); ++i) {
        SplitLine names = readNames(lines[i].text, row);
        names.line = i;
        const bool isComplete = names.isComplete() && (!row || names.fit(row));
        if (isComplete && (!row || names.delimiter == row->delimiter)) {
            return names;
        }
        if (isComplete && !otherwiseSplit) {
            otherwiseSplit = names;
        }
        if (!row || i < row->line) {
            above.push_back(std::move(names));
        }
    }
    if (otherwiseSplit) {
        return otherwiseSplit;
    }
    if (SplitLine *const named = findMostNames(above, row)) {
        return std::move(*named);
    }
    return row ? findUnknownHeadings(above, row) : std::move(above.front());
}

/// Inserts the heading that pandas prints for the first column in a line of its own, below the others. Returns the
/// number of these lines, 0 or 1.
std::size_t takeNameOfIndex(Lines rows, const std::optional<SplitLine> &row, std::vector<Heading> &headings)
{
    if (!row || rows.empty() || headings.size() + 1 != row->cells.size()) {
        return 0;
    }
    const Heading heading = parseHeading(trimmed(rows.front().text));
    if (heading.meaning.kind == Kind::Nothing) {
        return 0;
    }
    headings.insert(headings.begin(), heading);
    return 1;
}

/// Returns whether R or pandas wrote the names of the rows, which have no heading, before the cells: quoted, words, or
/// numbers from 0 or 1.
bool haveRowNames(Lines rows, char delimiter, std::size_t headings)
{
    constexpr std::size_t kExaminedRows = 2;
    if (rows.size() < kExaminedRows) {
        return false;
    }
    Cells numbers; // of the rows
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

/// Sets the unit of a column that is found in cell `i` of a line, unless it is empty. Throws if the heading states a
/// different one. What its brackets contain is a remark if it is no unit: "x (FD2)" above "mm".
void setUnit(std::vector<Heading> &headings, std::size_t i, std::string_view unit, std::size_t line)
{
    if (unit.empty() || i >= headings.size()) {
        return;
    }
    FileColumn &column = headings[i].use;
    const std::optional<Unit> stated = parseUnit(column.unit);
    if (stated && stated != parseUnit(unit)) {
        throw ReadError{line, i + 1, excerpt(unit), {ReadFault::Kind::UnitsContradict, {}, excerpt(column.heading)}};
    }
    if (!stated && !column.unit.empty()) {
        headings[i].name = column.heading;
    }
    column.unit = unit;
}

/// Splits a line into units, one for each heading, whatever separates them. Returns no cells if that is impossible.
Cells splitUnits(std::string_view line, const std::optional<SplitLine> &row, std::size_t headings)
{
    const auto isUnit = [](std::string_view cell) { return !unitIn(cell).empty(); };
    for (const SplitLine &way : waysToSplit(line, row)) {
        if (way.cells.size() == headings && std::ranges::all_of(way.cells, isUnit)) {
            return way.cells;
        }
    }
    return {};
}

/// Sets the units that stand directly above the headings, if all cells of the line are units: "s,cm", "# units: s, cm".
/// Otherwise the line has the names of headings that are only units: "Crank angle,Slider" above "[deg],Position [mm]".
void readLineAbove(const Line &line, const std::optional<SplitLine> &row, char delimiter,
                   std::vector<Heading> &headings)
{
    std::string_view text = withoutMark(line.text);
    const std::size_t colon = text.find(':');
    if (isAmong(lowered(text.substr(0, colon)), "unit units einheit einheiten unidad unidades")) {
        text = text.substr(colon + 1);
    }
    const Cells units = splitUnits(text, row, headings.size());
    for (std::size_t i = 0; i < units.size(); ++i) {
        setUnit(headings, i, unitIn(units[i]), line.number);
    }
    if (!units.empty()) {
        return;
    }
    const Cells names = delimiter != ' ' ? splitCells(text, delimiter) : Cells();
    for (std::size_t i = 0; i < std::min(names.size(), headings.size()); ++i) {
        const std::string &heading = headings[i].use.heading;
        if (!names[i].empty() && !unitIn(inBrackets(heading)).empty()) {
            headings[i] = parseHeading(std::string(names[i]) + ' ' + heading);
        }
    }
}

/// Returns the unknown unit in a cell of a line of units: "(V)", "px", "mm/deg". Longer words, abbreviations such as
/// "calc", and what has no brackets below a heading with a unit are remarks.
std::string_view unknownUnitIn(std::string_view cell, const Heading &heading)
{
    constexpr std::size_t kMaxUnitSize = 5; // bytes, without a slash
    const std::string_view inner = inBrackets(cell);
    if (!inner.empty() || !heading.use.unit.empty()) {
        return inner;
    }
    if (cell == "%") {
        return cell;
    }
    const std::vector<std::string> words = wordsOf(cell);
    const bool isRemark = words.empty() || isNumberOrGap(cell) || abbreviatesMethod(words);
    const bool isShort = cell.size() <= kMaxUnitSize || cell.find('/') != cell.npos;
    return isShort && !isRemark ? cell : std::string_view();
}

/// Returns whether a line below the headings is a second line of them: it names quantities, and states their units or
/// distinguishes equal headings, as "Position [mm]" and "Velocity [mm/s]" do below "Piston" and "Piston".
bool isSecondLineOfHeadings(const Cells &cells, const std::vector<Heading> &headings)
{
    bool namesQuantity = false;
    bool statesUnit = false;
    for (const std::string_view cell : cells) {
        const Heading second = parseHeading(cell);
        const bool isQuantity = second.meaning.kind >= Kind::Quantity && !second.meaning.hasUnknownWords;
        namesQuantity = namesQuantity || isQuantity;
        statesUnit = statesUnit || (isQuantity && !second.use.unit.empty());
    }
    const bool areEqual = std::ranges::any_of(headings, [&headings](const Heading &heading) {
        const auto isSame = [&heading](const Heading &other) { return other.use.heading == heading.use.heading; };
        return !heading.use.heading.empty() && std::ranges::count_if(headings, isSame) > 1;
    });
    return namesQuantity && (statesUnit || (areEqual && cells.size() <= headings.size()));
}

/// Returns whether a line below the headings states their symbols: "t", "φ", "s" below "Time", "Angle", "Distance". At
/// least one of them is no unit, unlike s.
bool areSymbols(const Cells &cells)
{
    const auto isSymbol = [](std::string_view cell) {
        const Heading heading = parseHeading(cell);
        return cell.empty() || (beginsWithSymbol(heading) && heading.use.unit.empty());
    };
    const auto isUnit = [](std::string_view cell) { return cell.empty() || parseUnit(cell); };
    return std::ranges::all_of(cells, isSymbol) && !std::ranges::all_of(cells, isUnit);
}

/// Interprets the lines between the headings and the first number, which may contain units or continue the headings.
/// Returns how many there are.
std::size_t readAnnotations(Lines lines, const std::optional<SplitLine> &row, char delimiter,
                            std::vector<Heading> &headings)
{
    std::size_t count = 0;
    for (; count < lines.size(); ++count) {
        const auto &[number, text] = lines[count];
        const std::string_view unmarked = withoutMark(text);
        Cells cells = splitUnits(unmarked, row, headings.size());
        if (cells.empty()) {
            cells = delimiter != ' ' ? splitCells(unmarked, delimiter) : readNames(text, row).cells;
        }
        if (isData(text) || std::ranges::any_of(cells, isNumber)) {
            break;
        }
        const bool areUnits = std::ranges::any_of(cells, [](std::string_view cell) { return !unitIn(cell).empty(); });
        const bool areNames = isSecondLineOfHeadings(cells, headings);
        if (!areNames && areSymbols(cells)) {
            continue;
        }
        headings.resize(areNames ? std::max(headings.size(), cells.size()) : headings.size()); // merged cells above
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const std::string_view unit = unitIn(cells[i]);
            if (areNames && unit.empty() && !cells[i].empty()) {
                const std::string first = headings[i].use.heading;
                const bool isRepeated = cells[i].starts_with(first); // "x" above "x (mm)"
                headings[i] = parseHeading(isRepeated ? std::string(cells[i]) : first + ' ' + std::string(cells[i]));
                continue;
            }
            const bool isUnknown = unit.empty() && areUnits && i < headings.size();
            setUnit(headings, i, isUnknown ? unknownUnitIn(cells[i], headings[i]) : unit, number);
        }
    }
    return count;
}

/// Interprets the lines between the headings and the numbers: the name of an index, units and further headings. Adds a
/// heading for row names without one. Returns the number of these lines.
std::size_t completeHeadings(Lines lines, const std::optional<SplitLine> &row, char delimiter,
                             std::vector<Heading> &headings)
{
    std::size_t count = takeNameOfIndex(lines, row, headings);
    count += readAnnotations(firstLines(lines.subspan(count)), row, delimiter, headings);
    if (haveRowNames(lines.subspan(count), delimiter, headings.size())) {
        headings.insert(headings.begin(), Heading());
    }
    return count;
}

/// Finds the columns of times of a clock by the cells of the first row. Times of day that no clock shows have no
/// meaning.
void findClocks(const Cells &cells, std::vector<Heading> &headings)
{
    for (std::size_t i = 0; i < std::min(cells.size(), headings.size()); ++i) {
        if (headings[i].meaning.kind >= Kind::Quantity) {
            break; // behind a quantity, "1:02" is a duration, as of a lap
        }
        const std::size_t colon = cells[i].find(':');
        headings[i].cells.isClock = colon != cells[i].npos;
        headings[i].cells.hasDate = cells[i].find_first_of("-/.") < colon;
    }
    for (Heading &heading : headings) {
        if (!heading.cells.isClock && isTimeOfDay(wordsOf(heading.name))) {
            heading.meaning = {};
        }
    }
}

/// Finds the decimal sign with which most numbers in the first lines can be read: 0,005 and 1.234,5 only with a comma.
/// Between commas, "1,234" could have a thousands separator and does not count, but "0,234" does. If each decimal sign
/// has three digits behind it and a number from 1 to 999 before, it could separate thousands everywhere.
void findDecimalSign(Lines lines, FileLayout &layout)
{
    int commas = 0; // numbers that need a comma, minus those that need a point
    bool isClear = layout.delimiter == ',';
    bool hasSign = false;
    for (const Line &line : lines) {
        for (const std::string_view cell : splitCells(line.text, layout.delimiter)) {
            const std::string text(splitUnit(cell).number);
            const bool isPoint = !parseNumber(text, DecimalSign::Point).fault;
            const bool mayHaveThousands = layout.delimiter == ',' && text.find(',') != text.npos &&
                                          !parseNumber(text + ".0", DecimalSign::Point).fault;
            const bool isComma = !mayHaveThousands && !parseNumber(text, DecimalSign::Comma).fault;
            commas += (isComma ? 1 : 0) - (isPoint ? 1 : 0);
            const std::size_t first = text.find_first_of("0123456789");
            const std::size_t sign = text.find_first_of(".,");
            if ((isPoint || isComma) && sign != text.npos) {
                hasSign = true;
                isClear = isClear || first >= sign || text[first] == '0' || sign - first > 3 || text.size() != sign + 4;
            }
        }
    }
    layout.decimalSign = commas > 0 ? DecimalSign::Comma : DecimalSign::Point;
    layout.mayBeThousands = hasSign && !isClear;
}

/// Returns whether the quantities are the rows of the table: one line begins with the name of the time or the crank
/// angle, another one with that of another quantity, and numbers follow.
bool isTransposed(Lines lines)
{
    constexpr std::size_t kFewestNumbers = 3;
    bool hasAbscissa = false;
    bool hasOther = false;
    for (const Line &line : lines) {
        for (const char delimiter : std::string_view("\t;,| ")) {
            const Cells cells = splitCells(line.text, delimiter);
            const auto numbers = static_cast<std::size_t>(std::ranges::count_if(cells, isNumber));
            const bool isQuantity = numbers >= kFewestNumbers && numbers + 2 >= cells.size() && !isNumber(cells[0]);
            const NameMeaning meaning = isQuantity ? parseHeading(cells[0]).meaning : NameMeaning();
            const bool isAbscissa = meaning.kind == Kind::Time || meaning.channel.coordinate == Theta2;
            hasAbscissa = hasAbscissa || (meaning.kind != Kind::Nothing && isAbscissa);
            hasOther = hasOther || (meaning.kind >= Kind::Quantity && !isAbscissa);
        }
    }
    return hasAbscissa && hasOther;
}

} // namespace

bool isProse(const std::vector<Line> &lines)
{
    constexpr std::size_t kMinLines = 10; // below, the fault of a line tells more
    constexpr std::size_t kMinRows = 3;   // in succession
    for (const char delimiter : std::string_view("\t;,|& ")) {
        std::size_t rows = 0;
        std::size_t cellsBefore = 0;
        for (const Line &line : lines) {
            const Cells cells = splitCells(line.text, delimiter);
            const auto numbers =
                static_cast<std::size_t>(std::ranges::count_if(cells, delimiter == ' ' ? isNumber : isData));
            const bool isTableRow = numbers > 1 && 2 * numbers >= cells.size();
            rows = isTableRow && (rows == 0 || cells.size() == cellsBefore) ? rows + 1 : 0;
            cellsBefore = cells.size();
            if (rows == kMinRows) {
                return false;
            }
        }
    }
    return lines.size() >= kMinLines;
}

std::string_view unitIn(std::string_view cell)
{
    constexpr std::string_view kUnit = "Unit:";
    if (const std::size_t at = cell.find(kUnit); at != cell.npos) {
        cell = trimmed(cell.substr(at + kUnit.size()));
        cell = cell.substr(0, cell.find_first_of(" \t;,"));
    } else if (const std::string_view inner = inBrackets(cell); !inner.empty()) {
        cell = inner;
    }
    return parseUnit(cell) ? cell : std::string_view();
}

std::vector<Heading> takeHeadings(std::vector<Line> &lines, FileLayout &layout)
{
    const Lines examined = firstLines(lines);
    if (lines.empty()) {
        throw ReadError{.fault = {ReadFault::Kind::Empty}};
    }
    const std::optional<SplitLine> row = findFirstRow(examined);
    const std::optional<SplitLine> labels = row ? std::nullopt : findLabelledRow(examined);
    if (!row && !labels && isProse(lines)) { // many words, whose meanings would take long to find
        throw ReadError{.fault = {ReadFault::Kind::NotATable}};
    }
    const std::optional<SplitLine> header = labels ? labels : findHeader(examined, row);
    const bool isSure = header && header->isComplete() && std::ranges::none_of(header->cells, isNumber);
    if (!isSure && isTransposed(examined)) {
        throw ReadError{.line = lines.front().number, .fault = {ReadFault::Kind::Transposed}};
    }
    layout.delimiter = row ? row->delimiter : header->delimiter;
    layout.headerLine = header ? lines[header->line].number : 0;
    Lines rows = lines;
    std::vector<Heading> headings;
    if (labels) {
        rows = rows.subspan(labels->line);
        headings = headingsOfLabels(*labels, rows.front());
    } else if (header) {
        rows = rows.subspan(header->line + 1);
        std::ranges::transform(withoutRemark(header->cells), std::back_inserter(headings), parseHeading);
        if (header->line > 0) {
            readLineAbove(lines[header->line - 1], row, layout.delimiter, headings);
        }
        rows = rows.subspan(completeHeadings(rows, row, layout.delimiter, headings));
    } else {
        rows = rows.subspan(row->line);
        headings.resize(row->cells.size());
    }
    for (std::size_t i = 0; row && i < std::min(row->cells.size(), headings.size()); ++i) {
        headings[i].cells.unit = splitUnit(row->cells[i]).unit;
        setUnit(headings, i, headings[i].cells.unit, lines[row->line].number);
    }
    interpretHeadings(headings);
    if (!labels && !rows.empty()) {
        findClocks(splitCells(rows.front().text, layout.delimiter), headings);
    }
    findDecimalSign(firstLines(rows), layout);
    lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(rows.size()));
    return headings;
}

} // namespace slidercrank
