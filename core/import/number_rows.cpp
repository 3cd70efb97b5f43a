// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/number_rows.h"

#include "core/import/heading.h"

#include <algorithm>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = NameMeaning::Kind;

/// Returns whether all cells are gaps or numbers, with or without units, and at least two are numbers.
bool isRow(const Cells &cells)
{
    return std::ranges::all_of(cells, isNumberOrGap) && std::ranges::count_if(cells, isNumber) >= 2;
}

/// Returns the number of cells of a row of numbers, with empty ones at the end; 0 for another line.
std::size_t sizeOfRow(const Line &line, char delimiter)
{
    return isRow(splitCells(line.text, delimiter)) ? countCells(line.text, delimiter) : 0;
}

} // namespace

bool isNumber(std::string_view cell)
{
    return looksNumeric(splitUnit(cell).number);
}

bool isNumberOrGap(std::string_view cell)
{
    const std::string_view number = splitUnit(cell).number;
    return !parseNumber(number, DecimalSign::Point).fault || !parseNumber(number, DecimalSign::Comma).fault;
}

std::size_t countCells(std::string_view line, char delimiter)
{
    return static_cast<std::size_t>(std::ranges::count(line, delimiter)) + 1;
}

NumberRow findFirstRow(Lines lines)
{
    for (const std::string_view delimiters : {kDelimiters, std::string_view(" ")}) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            for (const char delimiter : delimiters) {
                Cells cells = splitCells(lines[i].text, delimiter);
                if (!isRow(cells)) {
                    continue;
                }
                std::size_t size = cells.size();
                if (delimiter != ' ') {
                    const std::size_t sizeOfNext = i + 1 < lines.size() ? sizeOfRow(lines[i + 1], delimiter) : 0;
                    size = std::max(countCells(lines[i].text, delimiter), sizeOfNext);
                }
                return {std::move(cells), delimiter, size, i, lines[i].text};
            }
        }
    }
    return {};
}

bool isProse(const std::vector<Line> &lines)
{
    constexpr std::size_t kMinLines = 10; // in a shorter text, the error at a single line is the more helpful message
    constexpr std::size_t kMinRows = 3;   // in succession
    for (const char delimiter : kAllDelimiters) {
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

bool isTransposed(Lines lines)
{
    constexpr std::size_t kMinNumbers = 3;
    bool hasAbscissa = false;
    bool hasOther = false;
    for (const Line &line : lines) {
        for (const char delimiter : kAllDelimiters) {
            const Cells cells = splitCells(line.text, delimiter);
            const auto numbers = static_cast<std::size_t>(std::ranges::count_if(cells, isNumber));
            const bool areOthersNumbers = numbers + 2 >= cells.size(); // apart from a name and a unit
            const bool isQuantity = numbers >= kMinNumbers && areOthersNumbers && !isNumber(cells[0]);
            const NameMeaning meaning = isQuantity ? parseHeading(cells[0]).meaning : NameMeaning();
            const bool isAbscissa = meaning.kind == Kind::Time || meaning.channel.coordinate == Theta2;
            hasAbscissa = hasAbscissa || (meaning.kind != Kind::Nothing && isAbscissa);
            hasOther = hasOther || (meaning.kind >= Kind::Quantity && !isAbscissa);
        }
    }
    return hasAbscissa && hasOther;
}

} // namespace slidercrank
