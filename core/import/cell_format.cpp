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

/// Returns whether the first point or comma of a number may separate thousands, as in "80,826": a number from 1 to 999
/// is before it, and three digits are behind it.
bool maySeparateThousands(std::string_view number, std::size_t sign)
{
    const std::size_t first = number.find_first_of("0123456789");
    return first < sign && sign - first <= 3 && number[first] != '0' && number.size() == sign + 4;
}

} // namespace

void findClocks(const Line &row, char delimiter, std::vector<Heading> &headings)
{
    const Cells cells = splitCells(row.text, delimiter);
    for (std::size_t i = 0; i < std::min(cells.size(), headings.size()); ++i) {
        if (headings[i].meaning.kind >= NameMeaning::Kind::Quantity) {
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

void findDecimalSign(Lines lines, FileLayout &layout)
{
    const bool isBetweenCommas = layout.delimiter == ',';
    int commas = 0; // numbers that need a comma, minus those that need a point
    bool mayBeThousands = !isBetweenCommas;
    bool hasSign = false;
    for (const Line &line : lines) {
        for (const std::string_view cell : splitCells(line.text, layout.delimiter)) {
            const std::string number(splitUnit(cell).number);
            const std::size_t sign = number.find_first_of(".,");
            const bool hasThousands = isBetweenCommas && number.find(',') != number.npos &&
                                      !parseNumber(number + ".0", DecimalSign::Point).fault;
            const bool isWithPoint = !parseNumber(number, DecimalSign::Point).fault;
            const bool isWithComma = !hasThousands && !parseNumber(number, DecimalSign::Comma).fault;
            commas += (isWithComma ? 1 : 0) - (isWithPoint ? 1 : 0);
            if ((isWithPoint || isWithComma) && sign != number.npos) {
                hasSign = true;
                mayBeThousands = mayBeThousands && maySeparateThousands(number, sign);
            }
        }
    }
    layout.decimalSign = commas > 0 ? DecimalSign::Comma : DecimalSign::Point;
    layout.mayBeThousands = hasSign && mayBeThousands;
}

} // namespace slidercrank
