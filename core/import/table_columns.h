// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A text's table with what each column of it is: all that there is to know before the rows are read.

#include "core/import/byte_source.h"
#include "core/import/reference_data.h"
#include "core/import/table_layout.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace slidercrank
{

/// What a column's cells are.
struct ReadColumn {
    ColumnRole role = ColumnRole::Ignored; ///< Time: or the crank's angle in its place
    std::size_t series = 0;                ///< its place in TableLayout::channels
    /// Of a series: to the author's unit. Of the time: divides, so that 5 ms are 0.005 s; of the angle: to degrees.
    double factor = 1.0;
    std::string_view unit; ///< that stands in the cells themselves, behind the number
};

struct TableLayout {
    Table table;
    std::vector<ReadColumn> columns;
    std::vector<Channel> channels;
    std::size_t timeColumn = 0;
    bool isByAngle = false;    ///< that column is the crank's angle
    std::size_t dataBegin = 0; ///< offset of the table's data in the file
};

struct OpenedTable {
    Table table;               ///< with the encoding; no column has its role yet
    std::size_t dataBegin = 0; ///< offset of the table's data in the file
};

/// By what the file begins with. `beginning`: the text that the table refers to.
std::variant<OpenedTable, ReadError> openTable(const ByteSource &source, std::string &beginning);

/// By what the file begins with: all of it where it is not large. Where names do not tell, values from all over the
/// file do. `beginning`: the text that the table refers to. The error has the table's layout, if there is one, for a
/// person to choose from.
std::variant<TableLayout, ReadError> layOut(const ByteSource &source, std::string &beginning,
                                            const ReadOptions &options);

} // namespace slidercrank
