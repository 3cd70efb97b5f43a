// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the format of a reference file and the meaning of its columns.

#include "core/import/reference_data.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <vector>

namespace slidercrank
{

/// Returns the heading of a column as it is written in the file, or "column 3" if it has none.
QString headingWithoutFile(const FileLayout &layout, std::size_t column);

/// Returns the heading, followed by the name of the file if several files are joined: "Value (b.csv)".
QString headingText(const FileLayout &layout, std::size_t column);

/// Returns whether files are joined and the column only repeats time stamps that another column already gives.
bool repeatsTimeStamps(const FileLayout &layout, std::size_t column);

/// Returns the line number of a skipped row: "12", or "12 (b.csv)" if several files are joined.
QString lineText(const FileLayout &layout, const SkippedRow &row);

/// Returns the columns that are not used, except those that repeat the time stamps.
QStringList ignoredHeadings(const FileLayout &layout);

/// Returns a sentence each about the rows that were skipped, numbers that could be thousands, the columns that are not
/// used, and the columns whose meaning was guessed.
QStringList doubtTexts(const ReferenceData &data);

/// Returns a sentence with the options of the command line for each doubtful unit: that of lengths without a unit, that
/// of angles that are read in radians because of their values, and that of crank speeds in 1/s or Hz.
QStringList optionHints(const ReferenceData &data);

/// Returns the quantity in a column: "time", "θ³", or a dash if the column is ignored.
QString meaningText(const FileColumn &column);

/// Returns the unit of a column: "rad/s", or "° (none given)" if the file does not state it.
QString unitText(const FileColumn &column);

/// Returns the reason for the meaning of a column, as a clause. For finite differences, the version with a layout also
/// says which kind they are.
QString reasonText(ColumnReason reason);
QString reasonText(const FileLayout &layout, std::size_t column);

/// Describes how values are rounded: "significant digits: 6", or a dash if that is unknown.
QString roundingText(const Rounding &rounding);

/// Describes the layout of a file: "Columns separated by “,”, decimal point, headings in line 1". Returns the number of
/// files if several files are joined.
QString layoutText(const FileLayout &layout);

/// Returns the range of the abscissa: "t = 0 … 1 s" or "θ₂ = 0 … 360°".
QString abscissaText(const ReferenceData &data);

} // namespace slidercrank
