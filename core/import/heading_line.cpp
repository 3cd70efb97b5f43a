// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading_line.h"

#include "core/import/heading.h"

#include <algorithm>
#include <compare>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = NameMeaning::Kind;

/// Returns whether two headings denote the same: a time, or an angle or length of the same order.
bool denoteSameQuantity(const NameMeaning &first, const NameMeaning &second)
{
    if (first.kind < Kind::Quantity || second.kind < Kind::Quantity) {
        return first.kind == Kind::Time && second.kind == Kind::Time;
    }
    return isAngle(first.channel.coordinate) == isAngle(second.channel.coordinate) &&
           first.channel.order == second.channel.order;
}

/// Returns whether a cell continues the heading in the cell before it, as the unit in "Time, s", the symbol with its
/// unit in "Position, x (mm)", the number of the measurement in "Position (m), Run #1" and the end of the brackets in
/// "Crank angle (deg, CW)" do.
bool continuesHeading(std::string_view before, std::string_view cell)
{
    const bool areBracketsOpen = std::ranges::count(before, '(') > std::ranges::count(before, ')');
    if (areBracketsOpen || parseUnit(cell) || cell.starts_with("Run #")) {
        return true;
    }
    const Heading name = parseHeading(before);
    const Heading symbol = parseHeading(cell);
    return name.use.unit.empty() && !symbol.use.unit.empty() && beginsWithSymbol(symbol.name) &&
           denoteSameQuantity(name.meaning, symbol.meaning);
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

/// Returns whether all cells of a line are units or empty, also if one may be a symbol as well (s).
bool areUnits(const HeadingCandidate &line)
{
    return std::ranges::all_of(line.cells, [](std::string_view cell) { return cell.empty() || parseUnit(cell); });
}

/// If a line has more cells than the row, joins those into which the delimiter has split a heading. Keeps the cells as
/// they are if there are still not as many as in the row.
void joinHeadings(HeadingCandidate &names, const NumberRow &row)
{
    if (names.delimiter == ' ' || !row.isFound() || names.cells.size() <= row.sizeWithEmptyCells) {
        return;
    }
    HeadingCandidate joined = countNames(withHeadingsJoined(names.cells), names.delimiter);
    if (row.hasCountOf(joined.cells)) {
        names = std::move(joined);
    }
}

/// Returns whether a remark follows the headings. The cells must name a time and a quantity. Either the cells before
/// the first one with a comment mark are as many as the `numbers` of a row; or there are more cells than numbers, and
/// at least as many known names as numbers.
bool endsWithRemark(const HeadingCandidate &names, std::size_t numbers)
{
    const bool isRemarkMarked = headingsBeforeRemark(names.cells).size() == numbers;
    return names.isComplete() && (isRemarkMarked || (names.cells.size() > numbers && names.known() >= numbers));
}

/// Returns whether names may be the headings of the row:
///
/// 1. There is no row: true unless blanks separate the names.
/// 2. There are as many cells as in the row: true. But if blanks separate only the names, these must include a time and
///    a quantity, and at most one may be unknown.
/// 3. Otherwise, if blanks separate the names or the numbers: true only if blanks separate the names, there is one name
///    fewer than numbers, and all names are known and include a time and a quantity.
/// 4. Otherwise: true unless they are marked and no remark follows them.
///
/// `isMarked`: a comment mark was before the names.
bool mayBeHeadings(const HeadingCandidate &names, const NumberRow &row, bool isMarked)
{
    const bool areSpaced = names.delimiter == ' ';
    if (!row.isFound()) {
        return !areSpaced;
    }
    const std::size_t numbers = row.cells.size();
    if (row.hasCountOf(names.cells)) {
        return !areSpaced || row.delimiter == ' ' || (names.isComplete() && names.known() + 1 >= numbers);
    }
    if (areSpaced || row.delimiter == ' ') {
        return areSpaced && names.cells.size() + 1 == numbers && names.isComplete() &&
               names.known() == names.cells.size();
    }
    return !isMarked || endsWithRemark(names, numbers);
}

/// How well the cells of a line suit the row of numbers. The greater rank is better; the members are compared in order.
struct Rank {
    bool isLikeRow = false; ///< as many cells as in the row, between the same delimiters, which are not blanks
    std::size_t known = 0;  ///< number of names that are known
    bool hasCountOfRow = false;
    std::size_t cells = 0; ///< number of cells

    auto operator<=>(const Rank &) const = default;
};

Rank rankOf(const HeadingCandidate &names, const NumberRow &row)
{
    const bool hasCount = row.hasCountOf(names.cells);
    const bool isLikeRow = hasCount && names.delimiter == row.delimiter && names.delimiter != ' ';
    return {.isLikeRow = isLikeRow, .known = names.known(), .hasCountOfRow = hasCount, .cells = names.cells.size()};
}

/// Returns a line without the comment mark before its headings. A "#" that is the heading of the row numbers, as in
/// "#,t,x", stays: the line has as many cells as the row.
std::string_view withoutMarkOfHeadings(std::string_view line, const NumberRow &row)
{
    const bool isNumberSign = row.isFound() && row.delimiter != ' ' &&
                              trimmed(line).starts_with(std::string("#") + row.delimiter) &&
                              countCells(line, row.delimiter) == row.sizeWithEmptyCells;
    return isNumberSign ? line : withoutCommentMark(line);
}

} // namespace

HeadingCandidate countNames(Cells cells, char delimiter)
{
    HeadingCandidate names{std::move(cells), delimiter};
    for (const std::string_view cell : names.cells) {
        const bool isName = !looksNumeric(cell) && !parseUnit(textInBrackets(cell));
        const NameMeaning meaning = isName ? parseHeading(cell).meaning : NameMeaning();
        names.times += meaning.kind == Kind::Time ? 1 : 0;
        names.quantities += meaning.kind >= Kind::Quantity && !meaning.hasUnknownWords ? 1 : 0;
    }
    return names;
}

std::span<const std::string_view> headingsBeforeRemark(const Cells &headings)
{
    const auto isRemark = [](std::string_view cell) {
        return (cell.starts_with('%') || cell.starts_with('#')) && parseHeading(cell).meaning.kind == Kind::Nothing;
    };
    const auto remark = std::find_if(headings.begin() + (headings.empty() ? 0 : 1), headings.end(), isRemark);
    return {headings.begin(), remark};
}

std::vector<HeadingCandidate> waysToSplit(std::string_view line)
{
    std::vector<HeadingCandidate> ways;
    for (const char delimiter : kDelimiters) {
        ways.push_back(countNames(splitCells(line, delimiter), delimiter));
    }
    for (const Cells &cells :
         {splitCells(line, ' '), splitAtBlanks(line, 2), splitAtBlanks(line, 1), splitBehindBrackets(line)}) {
        ways.push_back(countNames(cells, ' '));
    }
    return ways;
}

HeadingCandidate readNames(std::string_view line, const NumberRow &row)
{
    const bool isSpaced = row.delimiter == ' ';
    const std::string_view unmarked = withoutMarkOfHeadings(line, row);
    if (isData(unmarked)) {
        return isSpaced ? HeadingCandidate{splitCells(unmarked, ' '), ' '} : HeadingCandidate();
    }
    const bool isMarked = unmarked.size() < line.size();
    for (const std::string_view text : {unmarked, line}) {
        HeadingCandidate best;
        for (HeadingCandidate &names : waysToSplit(text)) {
            joinHeadings(names, row);
            if (mayBeHeadings(names, row, isMarked) && rankOf(names, row) > rankOf(best, row)) {
                best = std::move(names);
            }
        }
        if (!best.cells.empty()) {
            return best;
        }
    }
    return isSpaced ? countNames(splitCells(unmarked, ' '), ' ') : HeadingCandidate();
}

std::optional<HeadingCandidate> findLineWithMostNames(const std::vector<HeadingCandidate> &lines, const NumberRow &row)
{
    const HeadingCandidate *best = nullptr;
    for (const HeadingCandidate &names : lines) {
        const std::size_t mostKnown = best ? best->known() : 0;
        if (names.delimiter == ' ' && 2 * names.known() < names.cells.size()) {
            continue;
        }
        const bool isTie = best && names.known() == mostKnown && !areUnits(names);
        if (names.known() > mostKnown || (isTie && row.hasCountOf(names.cells))) {
            best = &names;
        }
    }
    return best ? std::optional(*best) : std::nullopt;
}

std::optional<HeadingCandidate> findUnknownHeadings(const std::vector<HeadingCandidate> &lines, const NumberRow &row)
{
    const auto last = std::find_if_not(lines.rbegin(), lines.rend(), areUnits);
    const bool areHeadings =
        last != lines.rend() && row.hasCountOf(last->cells) && std::ranges::none_of(last->cells, looksNumeric);
    return areHeadings ? std::optional(*last) : std::nullopt;
}

} // namespace slidercrank
