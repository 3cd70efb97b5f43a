// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/unit_lines.h"

#include "core/import/heading_line.h"
#include "core/import/reference_data.h"
#include "core/import/vocabulary.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace slidercrank
{

namespace
{

using Kind = NameMeaning::Kind;

bool isUnit(std::string_view cell)
{
    return !unitIn(cell).empty();
}

/// Splits a line into units, one for each heading, whatever separates them. Returns no cells if that is impossible.
Cells splitUnits(std::string_view line, std::size_t headings)
{
    for (const HeadingCandidate &way : waysToSplit(line)) {
        if (way.cells.size() == headings && std::ranges::all_of(way.cells, isUnit)) {
            return way.cells;
        }
    }
    return {};
}

/// What a line between the headings and the numbers contains.
enum class Annotation {
    Units,
    SecondHeadings, ///< "Position [mm]" and "Velocity [mm/s]" below "Piston" and "Piston"
    Remarks,        ///< such as the symbols "t", "φ", "s" below "Time", "Angle", "Distance"
    Numbers
};

/// Returns the distance of the middle of a cell from the beginning of its line, doubled to be a whole number.
std::ptrdiff_t middleOf(std::string_view cell, std::string_view line)
{
    return 2 * (cell.data() - line.data()) + std::ssize(cell);
}

/// Puts the cells of a line that has fewer of them than the row of numbers above the nearest numbers, with empty cells
/// between them. Returns the cells as they are if two have the same nearest number.
Cells alignedWithRow(const Cells &cells, std::string_view line, const NumberRow &row)
{
    Cells aligned;
    for (const std::string_view cell : cells) {
        const auto nearest = std::ranges::min_element(row.cells, {}, [&](std::string_view number) {
            return std::abs(middleOf(number, row.text) - middleOf(cell, line));
        });
        const auto column = static_cast<std::size_t>(nearest - row.cells.begin());
        if (column < aligned.size()) {
            return cells;
        }
        aligned.resize(column);
        aligned.push_back(cell);
    }
    return aligned;
}

/// Splits a line between the headings and the numbers into cells.
Cells splitAnnotation(std::string_view line, const NumberRow &row, std::size_t headings)
{
    const std::string_view unmarked = withoutCommentMark(line);
    if (const Cells units = splitUnits(unmarked, headings); !units.empty()) {
        return units;
    }
    if (row.delimiter != ' ') {
        return splitCells(unmarked, row.delimiter);
    }
    const Cells cells = readNames(line, row).cells;
    return cells.size() < row.cells.size() ? alignedWithRow(cells, line, row) : cells;
}

/// Returns whether a line below the headings is a second line of headings: it names a quantity, and either states the
/// unit of one or distinguishes equal headings.
bool areSecondHeadings(const Cells &cells, const std::vector<Heading> &headings)
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

/// Returns whether all cells are symbols or empty. At least one symbol must not also be a unit, as s is; otherwise it
/// is a line of units.
bool areSymbols(const Cells &cells)
{
    const auto isSymbol = [](std::string_view cell) {
        const Heading heading = parseHeading(cell);
        return cell.empty() || (beginsWithSymbol(heading.name) && heading.use.unit.empty());
    };
    const auto mayBeUnit = [](std::string_view cell) { return cell.empty() || parseUnit(cell); };
    return std::ranges::all_of(cells, isSymbol) && !std::ranges::all_of(cells, mayBeUnit);
}

/// Returns what a line between the headings and the numbers, split into cells, contains.
Annotation annotationIn(const Line &line, const Cells &cells, const std::vector<Heading> &headings)
{
    if (isData(line.text) || std::ranges::any_of(cells, isNumber)) {
        return Annotation::Numbers;
    }
    if (areSecondHeadings(cells, headings)) {
        return Annotation::SecondHeadings;
    }
    return std::ranges::any_of(cells, isUnit) && !areSymbols(cells) ? Annotation::Units : Annotation::Remarks;
}

/// Returns the text of a cell that stands where a unit is expected but is no known one: "(V)", "px", "mm/deg". Returns
/// an empty text if the cell is a remark: without brackets below a heading that already has a unit, longer than
/// kMaxUnitSize, a number or a gap, or an abbreviation such as "calc".
std::string_view unknownUnitIn(std::string_view cell, const Heading &heading)
{
    constexpr std::size_t kMaxUnitSize = 5; // bytes; longer texts are units only if they contain a slash
    const std::string_view inner = textInBrackets(cell);
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

/// Sets the known and unknown units of the columns from a line with the number `line`.
void readUnits(const Cells &cells, std::size_t line, std::vector<Heading> &headings)
{
    for (std::size_t i = 0; i < std::min(cells.size(), headings.size()); ++i) {
        const std::string_view known = unitIn(cells[i]);
        setUnit(headings, i, known.empty() ? unknownUnitIn(cells[i], headings[i]) : known, line);
    }
}

/// Appends the second line of headings to the first one. The second one may have more cells, below merged cells.
void readSecondHeadings(const Cells &cells, std::size_t line, std::vector<Heading> &headings)
{
    headings.resize(std::max(headings.size(), cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (isUnit(cells[i]) || cells[i].empty()) {
            setUnit(headings, i, unitIn(cells[i]), line);
            continue;
        }
        const std::string first = headings[i].use.heading;
        const bool isRepeated = cells[i].starts_with(first); // "x" above "x (mm)"
        headings[i] = parseHeading(isRepeated ? std::string(cells[i]) : first + ' ' + std::string(cells[i]));
    }
}

} // namespace

std::string_view unitIn(std::string_view cell)
{
    constexpr std::string_view kUnit = "Unit:";
    if (const std::size_t at = cell.find(kUnit); at != cell.npos) {
        cell = trimmed(cell.substr(at + kUnit.size()));
        cell = cell.substr(0, cell.find_first_of(" \t;,"));
    } else if (const std::string_view inner = textInBrackets(cell); !inner.empty()) {
        cell = inner;
    }
    for (const std::string_view preposition : {"in ", "en "}) { // "in mm"
        cell.remove_prefix(cell.starts_with(preposition) ? preposition.size() : 0);
    }
    return parseUnit(cell) ? cell : std::string_view();
}

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

void readLineAbove(const Line &line, char delimiter, std::vector<Heading> &headings)
{
    std::string_view text = withoutCommentMark(line.text);
    const std::size_t colon = text.find(':');
    if (isAmong(lowered(text.substr(0, colon)), "unit units einheit einheiten unidad unidades")) {
        text = text.substr(colon + 1);
    }
    const Cells units = splitUnits(text, headings.size());
    for (std::size_t i = 0; i < units.size(); ++i) {
        setUnit(headings, i, unitIn(units[i]), line.number);
    }
    if (!units.empty() || delimiter == ' ') {
        return;
    }
    const Cells names = splitCells(text, delimiter);
    for (std::size_t i = 0; i < std::min(names.size(), headings.size()); ++i) {
        const std::string &heading = headings[i].use.heading;
        if (!names[i].empty() && isUnit(textInBrackets(heading))) {
            headings[i] = parseHeading(std::string(names[i]) + ' ' + heading);
        }
    }
}

std::size_t readAnnotations(Lines lines, const NumberRow &row, std::vector<Heading> &headings)
{
    std::size_t count = 0;
    for (const Line &line : lines) {
        const Cells cells = splitAnnotation(line.text, row, headings.size());
        switch (annotationIn(line, cells, headings)) {
        case Annotation::Numbers: return count;
        case Annotation::SecondHeadings: readSecondHeadings(cells, line.number, headings); break;
        case Annotation::Units: readUnits(cells, line.number, headings); break;
        case Annotation::Remarks: break;
        }
        ++count;
    }
    return count;
}

} // namespace slidercrank
