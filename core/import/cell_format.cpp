// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/cell_format.h"

#include "core/import/cells.h"
#include "core/import/vocabulary.h"

#include <algorithm>
#include <string>

namespace slidercrank
{

namespace
{

/// Returns whether the first point or comma of a number, at `sign`, may separate thousands, as in "80,826": a number
/// from 1 to 999 is before it, and three digits are behind it.
bool maySeparateThousands(std::string_view number, std::size_t sign)
{
    const std::size_t first = number.find_first_of("0123456789");
    return first < sign && sign - first <= 3 && number[first] != '0' && number.size() == sign + 4;
}

/// Returns the cells of the lines without the units behind their numbers.
std::vector<std::string_view> numbersIn(Lines lines, char delimiter)
{
    std::vector<std::string_view> numbers;
    for (const Line &line : lines) {
        for (const std::string_view cell : splitCells(line.text, delimiter)) {
            numbers.push_back(splitUnit(cell).number);
        }
    }
    return numbers;
}

/// Returns whether a text is a gap or a number that is valid with a decimal point.
bool isNumberWithPoint(std::string_view text)
{
    return !parseNumber(text, DecimalSign::Point).fault;
}

/// Returns whether a text is a gap or a number that is valid with a decimal comma. If commas also separate the cells, a
/// comma that may separate thousands ("1,234") is no decimal comma.
bool isNumberWithComma(std::string_view text, char delimiter)
{
    const bool hasComma = text.find(',') != text.npos;
    const bool hasThousands = delimiter == ',' && hasComma && isNumberWithPoint(std::string(text) + ".0"); // "1,234.0"
    return !hasThousands && !parseNumber(text, DecimalSign::Comma).fault;
}

} // namespace

void markClocks(const Line &row, char delimiter, std::vector<Heading> &headings)
{
    const Cells cells = splitCells(row.text, delimiter);
    for (std::size_t i = 0; i < std::min(cells.size(), headings.size()); ++i) {
        if (headings[i].meaning.kind >= NameMeaning::Kind::Quantity) {
            break; // behind a quantity, "1:02" is a duration
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

DecimalSign findDecimalSign(Lines lines, char delimiter)
{
    int commas = 0; // numbers that are valid with a comma, minus those that are valid with a point
    for (const std::string_view number : numbersIn(lines, delimiter)) {
        commas += (isNumberWithComma(number, delimiter) ? 1 : 0) - (isNumberWithPoint(number) ? 1 : 0);
    }
    return commas > 0 ? DecimalSign::Comma : DecimalSign::Point;
}

bool mayHaveThousands(Lines lines, char delimiter)
{
    bool hasSign = false;
    bool mayBeThousands = delimiter != ',';
    for (const std::string_view number : numbersIn(lines, delimiter)) {
        const std::size_t sign = number.find_first_of(".,");
        if (sign != number.npos && (isNumberWithPoint(number) || isNumberWithComma(number, delimiter))) {
            hasSign = true;
            mayBeThousands = mayBeThousands && maySeparateThousands(number, sign);
        }
    }
    return hasSign && mayBeThousands;
}

} // namespace slidercrank
