// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The exported motion of a simulation: the bytes of a file → named series in the author's units (mm, °, s), with what
// each column was taken for and why, or an error that says line, column and text. Locale-free; nothing throws.
//
// Reading has three stages: text (file_text.h), table of numbers (raw_table.h), meaning of the columns
// (column_assignment.h).
//
// A table by the crank angle instead of the time is read as the motion of a crank that turns once a second, until
// somebody says otherwise.
//
// Text in UTF-8, UTF-16 or Windows-1252. Any lines, then one that names the columns: the time and the channels
// (nameOf(), or words), in any order and case, each with its unit or none for the author's; perhaps a line of units.
// Length: mm, cm, m, in. Angle: °, deg, rad. Derivatives: per s or ms, squared as s^2, s2, s² or /s/s. Time: s, ms, us,
// min. Cells are separated by commas, semicolons, tabs, or, where none of these does it, by runs of spaces; they may be
// quoted; a cell never spans lines. The names may stand behind a comment's mark (#, %, //), a unit in every cell of a
// column. Numbers hold a decimal point or a decimal comma, the same throughout a file, and separators of thousands
// where they cannot be mistaken. An empty cell or "nan" is a gap. Of rows with the same time the last one counts.
//
// In a file of two columns, a plot, the heading beside the time stamps may say nothing ("Value", "y"): then the name of
// the file may ("slider_velocity.csv").
//
// A name that leaves open which channel it is, is guessed at only where unit and values do not contradict it, and the
// guess is marked in the layout; otherwise the column is left out.

#include "core/import/read_fault.h"
#include "core/import/rounding.h"
#include "core/mechanism/channel.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace slidercrank
{

/// One column: values at ReferenceData::time, in the author's unit of its channel; NaN where the cell was empty.
struct ReferenceSeries {
    Channel channel;
    std::vector<double> values;
    Rounding rounding; ///< how the file rounded this column, already in the author's unit
};

/// A row that could not be read and was left out. Lines and columns count from 1, columns in cells.
struct SkippedRow {
    std::size_t line = 0;
    std::size_t column = 0;
    std::string text; ///< the offending cell, shortened
    RowFault fault = RowFault::NotANumber;
    std::size_t rows = 1; ///< that it stands for, itself among them
    std::size_t file = 0; ///< of FileLayout::files
};

/// What a file counts by that has no time.
struct CrankAngles {
    std::vector<double> degrees; ///< θ2, one a row, rising or falling throughout
    Rounding rounding;           ///< how the file rounded them

    // Of the crank that ReferenceData::time was made for: see crank_angles.h. As read, one that turns once a second.
    double omega2 = 2.0 * std::numbers::pi;
    double theta20 = 0.0;
};

struct ReferenceData {
    std::vector<double> time; ///< s, strictly increasing
    Rounding timeRounding;    ///< how the file rounded the instants, already in seconds
    std::vector<ReferenceSeries> series;
    std::vector<SkippedRow> skipped;    ///< at most 1000, and then one more that counts the others
    FileLayout layout;                  ///< how the file is written, and what each column became and why
    std::optional<CrankAngles> crank{}; ///< where the file counts by them: the instants follow
    std::vector<std::size_t> lines{};   ///< of the (first) file, where each row stands, from 1; empty where unknown

    /// The line of that row; without lines, its number from 1.
    std::size_t lineOfRow(std::size_t row) const { return row < lines.size() ? lines[row] : row + 1; }

    const ReferenceSeries *find(Channel channel) const;

    std::size_t skippedRowCount() const; ///< listed and not
};

/// Of its series.
ChannelSet channelsOf(const ReferenceData &data);

/// Why nothing sensible could be read, and where. line 0: the file as a whole.
struct ReadError {
    std::size_t line = 0;
    std::size_t column = 0;
    std::string text{};
    ReadFault fault{};
    FileLayout layout{}; ///< what was found; with columns, a person's choice of them may still help

    // Of several files that are to be joined.
    std::optional<std::size_t> file{};      ///< where it is; none: in all of them, or there is one
    std::optional<std::size_t> otherFile{}; ///< that ReadFault::heading is the name of
};

/// What the finite ones among some values span.
struct ValueRange {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    std::size_t count = 0;

    double width() const { return high - low; }
    double size() const { return std::max({0.0, -low, high}); } ///< the largest magnitude
};

ValueRange rangeOf(std::span<const double> values);

struct ReadOptions {
    std::vector<ColumnChoice> columns; ///< the columns not named here are what they were without

    /// Called from the reading thread now and then, with the bytes done of all. May be empty.
    std::function<void(std::size_t done, std::size_t all)> progress;

    std::vector<NamedChoice> named{}; ///< as `columns`, and over those
};

/// A file in memory.
struct FileBytes {
    std::string_view bytes;
    std::string name{};       ///< "slider_velocity.csv"; empty: none
    bool isBeginning = false; ///< of a file that goes on
};

/// What the beginning of a file shows; larger files are refused.
inline constexpr std::size_t kFileBeginning = std::size_t{1} << 16U;
inline constexpr std::size_t kLargestReferenceFile = std::size_t{1} << 31U;

/// Why a file that begins like this is no table of text: a spreadsheet, PDF, markup, JSON or binary data. Asked with
/// kFileBeginning bytes before a large file is read.
std::optional<ReadError> findForeignFormat(std::string_view beginning);

/// A channel or time that stands there twice under its own name, an unknown unit of either and a time that decreases
/// are refused rather than guessed at; a row that cannot be read is left out and reported. Watches `stop`.
std::variant<ReferenceData, ReadError> readReferenceData(std::string_view bytes, std::stop_token stop = {},
                                                         const ReadOptions &options = {});

/// The same of a named file, or of several files of one motion, a plot each, as programs write them that export one
/// plot at a time. Their rows are those of one table, whose columns are those of all files: their time stamps (or crank
/// angles) have to be the same as far as they are printed, and a row left out of one file is left out of all. A channel
/// comes from one file only. In `options`, columns count on from file to file; what is chosen as the time, or the
/// angle, of the first file holds for a column of that heading in the others, too. An error has the columns of the
/// files up to the one that cannot be read.
std::variant<ReferenceData, ReadError> readFiles(std::span<const FileBytes> files, std::stop_token stop = {},
                                                 const ReadOptions &options = {});

} // namespace slidercrank
