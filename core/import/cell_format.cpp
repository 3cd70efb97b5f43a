// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/cell_format.h"

#include "core/import/cells.h"
#include "core/import/vocabulary.h"

#include <algorithm>
#include <string>

namespace slidercrank
{

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

} // namespace slidercrank
