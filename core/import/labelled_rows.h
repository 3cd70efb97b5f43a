// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables without a line of headings, whose cells contain them as labels, as the serial plotter of Arduino writes them:
//
//     t:0.1,angle:12.5          x = 85 mm, y = 3 mm

#include "core/import/cells.h"
#include "core/import/heading.h"
#include "core/import/lines.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace slidercrank
{

/// A row whose cells have labels.
struct LabelledRow {
    Cells labels{}; ///< with their marks ":" and "="; a cell that is only a label is its own label
    char delimiter = ',';
    std::size_t line = 0; ///< index among the lines of the file
};

/// Returns the first line whose cells have the same labels before their numbers as those of the next line.
std::optional<LabelledRow> findLabelledRow(Lines lines);

/// Returns the headings of the table, with the labels and units of the cells in `line`, its first row. The columns of
/// cells that are only labels have empty headings.
std::vector<Heading> headingsOfLabels(const LabelledRow &row, const Line &line);

} // namespace slidercrank
