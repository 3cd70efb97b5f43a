// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Third stage of reading: the tables of one or several files with the meaning of their columns.

#include "core/import/column_assignment.h"
#include "core/import/raw_table.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace slidercrank
{

/// A file's table and what its columns are used for; those that are used hold seconds, degrees and the author's units.
struct AssignedTable {
    RawTable table;
    std::vector<ColumnAssignment> uses;
    std::size_t firstColumn = 0; ///< its number among the columns of all files
    std::size_t abscissa = 0;
};

/// Settles what each column is in all tables, those without headings excepted, and describes them in `layout`. Returns
/// why that cannot be done, or why the files are not of one motion as far as their columns tell.
std::optional<ReadError> assignAll(std::vector<AssignedTable> &tables, std::span<const FileBytes> files,
                                   const ReadOptions &options, FileLayout &layout);

/// Why the row cannot be used: the first cell at fault among those that are used.
std::optional<SkippedRow> findFault(const AssignedTable &file, std::size_t row);

/// The shortest text of that number.
std::string printedNumber(double value);

} // namespace slidercrank
