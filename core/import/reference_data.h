// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads the exported motion of a simulation: from the bytes of a file to named series in the default units (mm, °, s),
// with the meaning of each column and its reason, or to an error with line, column and text. The functions do not
// depend on the locale and do not throw.
//
// Reading has three stages: text (file_text.h), table of numbers (raw_table.h), meaning of the columns
// (column_assignment.h).
//
// A line names the columns: the time and the channels (nameOf(), or words), in any order and case, each with or without
// its unit. There may be other lines above it, and a line of units below. A comment mark (#, %, //) before the names is
// ignored. Cells are separated by commas, semicolons, tabs or vertical bars, or else by spaces, and may be quoted; only
// a heading may contain a line break. Numbers have a decimal point or a decimal comma, the same throughout a file, and
// thousands separators where they are unambiguous. An empty or missing cell is a gap. Of rows with the same time, the
// last one is used.
//
// A table over the crank angle instead of the time is read as the motion of a crank that turns once a second, until
// timedBy() is called with a mechanism.
//
// If a heading leaves open which channel it is, the usual one is assumed, unless the unit contradicts it. Such a guess
// is marked in the layout. Other columns are ignored.

#include "core/import/read_fault.h"
#include "core/import/rounding.h"
#include "core/import/value_sequence.h"
#include "core/mechanism/channel.h"

#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace slidercrank
{

/// A column of values at ReferenceData::time, in the default unit of the channel; NaN for an empty cell.
struct ReferenceSeries {
    Channel channel;
    std::vector<double> values;
    Rounding rounding; ///< of the values in the file, converted to the default unit
};

/// A row that was skipped. Lines and columns count from 1.
struct SkippedRow {
    std::size_t line = 0;
    std::size_t column = 0;
    std::string text; ///< the beginning of the cell
    RowFault fault = RowFault::NotANumber;
    std::size_t file = 0; ///< index in FileLayout::files
};

/// The abscissa of a table over the crank angle.
struct CrankAngles {
    std::vector<double> degrees; ///< θ2 of each row, strictly increasing or decreasing
    Rounding rounding;           ///< of the angles in the file

    // The drive for which ReferenceData::time was computed: see crank_angles.h. By default, one turn per second.
    double omega2 = 2.0 * std::numbers::pi;
    double theta20 = 0.0;
};

struct ReferenceData {
    std::vector<double> time; ///< s, strictly increasing
    Rounding timeRounding;    ///< of the time stamps in the file, converted to seconds
    std::vector<ReferenceSeries> series;
    std::vector<SkippedRow> skipped;    ///< the first 1000
    std::size_t skippedCount = 0;       ///< number of all skipped rows
    FileLayout layout;                  ///< how the file is written, and the meaning of each column
    std::optional<CrankAngles> crank{}; ///< of a table over the crank angle, from which the time stamps follow
    std::vector<std::size_t> lines{};   ///< line of each row in the (first) file, from 1; empty if unknown

    /// Returns the line of a row, or if it is unknown, the number of the row from 1.
    std::size_t lineOfRow(std::size_t row) const { return row < lines.size() ? lines[row] : row + 1; }

    const ReferenceSeries *find(Channel channel) const;
};

ChannelSet channelsOf(const ReferenceData &data);

struct ReadOptions {
    std::vector<ColumnChoice> columns; ///< the last one for a column applies; for the other columns, the file decides

    /// Called regularly from the reading thread with the fraction that has been read, from 0 to 1; returns false to
    /// stop reading. May be empty.
    std::function<bool(double fraction)> progress;
};

struct FileBytes {
    std::string_view bytes;
    std::string name{};       ///< "slider_velocity.csv"; empty: unknown
    bool isBeginning = false; ///< whether the file continues after these bytes; if so, all files get as many rows as
                              ///< the one with fewest
};

/// Number of bytes that are checked before a large file is read.
inline constexpr std::size_t kFileBeginning = std::size_t{1} << 16U;

/// Largest size of a file, in bytes.
inline constexpr std::size_t kLargestReferenceFile = std::size_t{1} << 31U;

/// Returns the error of a file that begins like this and is no table of text: a spreadsheet, PDF, markup, JSON or
/// binary data. Otherwise returns nullopt. `beginning` has kFileBeginning bytes, or fewer if the file is smaller.
std::optional<ReadError> findForeignFormat(std::string_view beginning);

/// Reads a file, or several files of one motion, as written by programs that export one plot at a time. Contradictions
/// are errors: the same channel or time twice, an unknown unit of a channel, a time that decreases. A row that cannot
/// be read is skipped and listed. Several files are joined side by side: they must have the same time stamps (or crank
/// angles), apart from the rounding errors of a unit conversion, and a row that is skipped in one file is skipped in
/// all. Each channel must be in one file only. In `options`, the columns of all files are numbered consecutively; a
/// column that is chosen as the abscissa of the first file is that of the other files, too, where they have the same
/// heading. An error contains the columns up to those of the file with the error.
std::variant<ReferenceData, ReadError> readFiles(std::span<const FileBytes> files, const ReadOptions &options = {});

} // namespace slidercrank
