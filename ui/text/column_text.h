// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a reference file is written and what its columns mean, in words.

#include "core/import/reference_data.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <vector>

namespace slidercrank
{

/// As printed; "column 3" if there is none.
QString headingAlone(const FileLayout &layout, std::size_t column);

/// With the name of the file, "Value (b.csv)", if several are joined.
QString headingText(const FileLayout &layout, std::size_t column);

/// Whether the column only repeats the time stamps of files that are joined.
bool repeatsInstants(const FileLayout &layout, std::size_t column);

/// "12", or "12 (b.csv)" if several files are joined.
QString lineText(const FileLayout &layout, const SkippedRow &row);

/// Columns that are not used, without those that repeat the time stamps.
std::vector<std::size_t> ignoredColumns(const FileLayout &layout);
QStringList ignoredHeadings(const FileLayout &layout);

/// "time", "θ³", or a dash for a column that is ignored.
QString meaningText(const FileColumn &column);

/// "rad/s", or "° (none given)".
QString unitText(const FileColumn &column);

/// Why a column has its meaning, as a clause.
QString reasonText(const FileLayout &layout, std::size_t column);

/// "significant digits: 6", or a dash if it is unknown.
QString roundingText(const Rounding &rounding);

/// "UTF-8, columns separated by commas, decimal point, headings in line 1"
QString formText(const FileLayout &layout);

/// The range of the rows: "t = 0 … 1 s", or "θ₂ = 0 … 360°".
QString abscissaText(const ReferenceData &data);

} // namespace slidercrank
