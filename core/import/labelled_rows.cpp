// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/labelled_rows.h"

#include "core/import/number_rows.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

/// Returns the label before the number in a cell, with the mark behind the label: "angle:" of "angle:12.5", "x =" of
/// "x = 85 mm". Empty if there is none.
std::string_view labelOf(std::string_view cell)
{
    const std::size_t mark = cell.find_first_of(":=");
    const bool isLabelled =
        mark != cell.npos && mark > 0 && !isDigit(cell[0]) && isNumber(trimmed(cell.substr(mark + 1)));
    return isLabelled ? cell.substr(0, mark + 1) : std::string_view();
}

/// Returns the label of each cell of a line. The label of a number is in its own cell, "x=85", or in those before it,
/// as in "x= 85" and "x = 85" between blanks. A cell that is only a label or its mark is its own label. Other cells
/// have an empty label.
Cells labelsOf(const Line &line, char delimiter)
{
    const Cells cells = splitCells(line.text, delimiter);
    const auto hasMark = [&cells](std::size_t i) { return cells[i].ends_with('=') || cells[i].ends_with(':'); };
    Cells labels;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const bool isBeforeMark = i + 1 < cells.size() && cells[i + 1] == "=";
        if (isNumber(cells[i]) && i > 0 && hasMark(i - 1)) {
            const bool isMarkApart = cells[i - 1] == "=" && i > 1;
            labels.push_back(cells[isMarkApart ? i - 2 : i - 1]);
        } else if (!isNumber(cells[i]) && (hasMark(i) || isBeforeMark)) {
            labels.push_back(cells[i]);
        } else {
            labels.push_back(labelOf(cells[i]));
        }
    }
    return labels;
}

/// Returns the headings of the columns, with the labels and units of the cells of the first row. `labels`: of `cells`.
std::vector<Heading> headingsOf(const Cells &labels, const Cells &cells)
{
    std::vector<Heading> headings;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string_view label = labels[i]; // with its mark ":" or "="
        if (label == cells[i]) {                  // without a number
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

} // namespace

std::optional<TableTop> readLabelledRows(Lines lines)
{
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        for (const char delimiter : kAllDelimiters) {
            const Cells labels = labelsOf(lines[i], delimiter);
            const bool areLabels = labels.size() > 1 && std::ranges::count(labels, std::string_view()) == 0;
            if (areLabels && labels == labelsOf(lines[i + 1], delimiter)) {
                return TableTop{.headings = headingsOf(labels, splitCells(lines[i].text, delimiter)),
                                .headerLine = lines[i].number,
                                .firstRow = i,
                                .delimiter = delimiter};
            }
        }
    }
    return std::nullopt;
}

} // namespace slidercrank
