// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a reference file is written and what its columns became, in words.

#include "core/import/reference_data.h"

#include <QString>
#include <QStringList>

#include <cstddef>
#include <vector>

namespace slidercrank
{

/// As printed; "column 3" where nothing is.
QString headingAlone(const FileLayout &layout, std::size_t column);

/// The same with the file, "Value (b.csv)", where several are joined.
QString headingText(const FileLayout &layout, std::size_t column);

/// Whether it only holds the instants of all files that are joined once more.
bool repeatsInstants(const FileLayout &layout, std::size_t column);

/// Where the row stands: "12", or "12 (b.csv)" where several files are joined.
QString lineText(const FileLayout &layout, const SkippedRow &row);

/// The columns that mean no channel, or hold no number; those that repeat the instants apart.
std::vector<std::size_t> ignoredColumns(const FileLayout &layout);
QStringList ignoredHeadings(const FileLayout &layout);

/// "time", "θ³", or a dash for a column that is ignored.
QString meaningText(const FileColumn &column);

/// "rad/s"; "° (none given)" where the author's was taken.
QString unitText(const FileColumn &column);

/// Why it became that, a clause; and in a few words, for a table.
QString reasonText(const FileLayout &layout, std::size_t column);
QString shortReasonText(const FileLayout &layout, std::size_t column);

/// "6 significant digits"; a dash where it is not known.
QString roundingText(const Rounding &rounding);

/// "UTF-8, columns apart by commas, decimal point, names in line 1"
QString formText(const FileLayout &layout);

/// From where to where the rows go: "t = 0 … 1 s", or "θ² = 0 … 360°" where they count by the crank's angle.
QString abscissaText(const ReferenceData &data);

} // namespace slidercrank
