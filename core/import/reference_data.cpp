// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/reference_data.h"

#include "core/import/assigned_table.h"
#include "core/import/cells.h"
#include "core/import/clock.h"
#include "core/import/crank_angles.h"
#include "core/import/difference.h"
#include "core/import/file_text.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;

/// Keeps the rows whose mark is set.
template <typename Value>
void keepRows(std::vector<Value> &values, const std::vector<bool> &marks)
{
    std::size_t row = 0;
    std::erase_if(values, [&](const Value &) { return !marks[row++]; });
}

void keepRows(ReferenceData &data, const std::vector<bool> &marks)
{
    keepRows(data.time, marks);
    keepRows(data.lines, marks);
    for (ReferenceSeries &series : data.series) {
        keepRows(series.values, marks);
    }
}

/// Lists a row that is left out; where the list is full, counts it.
void leaveOut(SkippedRow row, std::vector<SkippedRow> &skipped)
{
    if (skipped.size() > kMostSkippedRows) {
        ++skipped.back().rows;
    } else if (skipped.size() == kMostSkippedRows) {
        skipped.push_back({row.line, 0, {}, RowFault::NotListed, 1, row.file});
    } else {
        skipped.push_back(std::move(row));
    }
}

/// Lists the rows that cannot be used in one of the files, and returns which can be used in all.
std::vector<bool> markRows(std::span<const AssignedTable> files, std::vector<SkippedRow> &skipped)
{
    std::vector<bool> marks(files.front().table.lines.size(), true);
    for (const AssignedTable &file : files) {
        for (std::size_t i = 0; i < file.uses.size(); ++i) {
            const std::vector<double> &values = file.table.columns[i];
            for (std::size_t row = 0; row < marks.size() && file.uses[i].role != ColumnRole::Ignored; ++row) {
                marks[row] = marks[row] && !std::isinf(values[row]) && !(i == file.abscissa && std::isnan(values[row]));
            }
        }
    }
    for (std::size_t row = 0; row < marks.size(); ++row) {
        for (std::size_t i = 0; i < files.size() && !marks[row]; ++i) {
            if (std::optional<SkippedRow> fault = findFault(files[i], row)) {
                fault->file = i;
                leaveOut(*std::move(fault), skipped);
                break;
            }
        }
    }
    return marks;
}

/// The series of all files, with all rows, over the time stamps of the first file.
ReferenceData mergeColumns(std::vector<AssignedTable> &files, FileLayout layout)
{
    ReferenceData data;
    data.layout = std::move(layout);
    data.lines = std::move(files.front().table.lines);
    data.time = files.front().table.columns[files.front().abscissa];
    for (AssignedTable &file : files) {
        for (std::size_t i = 0; i < file.uses.size(); ++i) {
            if (file.uses[i].role == ColumnRole::Channel) {
                const double factor = file.uses[i].factor;
                data.series.push_back(
                    {file.uses[i].channel, std::move(file.table.columns[i]), file.table.roundings[i].infer(factor)});
            }
        }
    }
    return data;
}

/// Whether two lists of time stamps are the same as far as they are printed; nearer than a quarter of their spacing.
bool areSameInstants(const std::vector<double> &x, const Rounding &ofX, const std::vector<double> &y,
                     const Rounding &ofY)
{
    constexpr double kUlps = 4.0; // of a change of unit in either
    constexpr double kOfSpacing = 0.25;
    const double spacing = std::abs(x.back() - x.front()) / static_cast<double>(std::max<std::size_t>(x.size() - 1, 1));
    const double rounded = 0.5 * (clockOf(x, ofX).step() + clockOf(y, ofY).step());
    const double allowed = std::min(rounded, kOfSpacing * spacing);
    return std::ranges::equal(x, y, [allowed](double a, double b) {
        const double ulps = kUlps * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
        return std::abs(a - b) <= allowed + ulps;
    });
}

/// Takes the time stamps of the file that prints most digits of them; an error where they are not the same in all.
std::optional<ReadError> joinInstants(ReferenceData &data, std::vector<AssignedTable> &files,
                                      const std::vector<bool> &marks)
{
    const auto roundingOf = [](const AssignedTable &file) {
        return file.table.roundings[file.abscissa].inferOfInstants(1.0 / file.uses[file.abscissa].factor);
    };
    const std::vector<double> first = data.time;
    const Rounding ofFirst = data.timeRounding = roundingOf(files.front());
    for (std::size_t i = 1; i < files.size(); ++i) {
        const AssignedTable &file = files[i];
        std::vector<double> next = file.table.columns[file.abscissa];
        keepRows(next, marks);
        const Rounding rounding = roundingOf(file);
        if (!first.empty() && !areSameInstants(first, ofFirst, next, rounding)) {
            return ReadError{0, 0, {}, {Fault::OtherInstants, {}, data.layout.files[0]}, {}, i, 0};
        }
        if (rounding.finestStep() > 0.0 && rounding.finestStep() < data.timeRounding.finestStep()) {
            data.time = std::move(next);
            data.timeRounding = rounding;
        }
        FileColumn &column = data.layout.columns[file.firstColumn + file.abscissa];
        column.role = ColumnRole::Ignored;
        column.reason = ColumnReason::SameInstants;
        column.otherColumn = files.front().abscissa;
    }
    return std::nullopt;
}

/// Makes time stamps of the crank angles that were read in their place.
std::optional<ReadError> countByAngle(ReferenceData &data, const AssignedTable &file)
{
    data.crank.emplace();
    data.crank->degrees = goingOn(data.time);
    data.crank->rounding = data.timeRounding;
    if (const std::optional<std::size_t> row = turnsBackAt(data.crank->degrees)) {
        ReadFault fault{Fault::AngleTurnsBack};
        fault.heading = printedNumber(data.time[*row - 1]) + "°";
        return ReadError{file.table.layout.headerLine, file.abscissa + 1,
                         excerpt(file.table.headings[file.abscissa].printed), std::move(fault)};
    }
    std::optional<ReferenceData> timed = timedBy(Mechanism(), data);
    if (!timed) {
        return ReadError{
            file.table.firstDataLine, file.abscissa + 1, {}, {.kind = Fault::NoRow, .row = RowFault::TooLarge}};
    }
    data = *std::move(timed);
    return std::nullopt;
}

/// Refuses a time that decreases. Of rows with the same time the last one is kept, as it holds the state after an
/// event; where most rows repeat the time, it is refused as well.
std::optional<ReadError> settleTime(ReferenceData &data, const AssignedTable &file)
{
    const auto describe = [&](std::size_t row) {
        const std::string text = printedNumber(data.time[row] * file.uses[file.abscissa].factor);
        return SkippedRow{data.lines[row], file.abscissa + 1, text, RowFault::RepeatedTime};
    };
    std::vector<bool> marks(data.time.size(), true);
    std::vector<std::size_t> repeated;
    std::optional<std::size_t> wrong;
    for (std::size_t row = 1; row < data.time.size() && !wrong; ++row) {
        wrong = data.time[row] < data.time[row - 1] ? std::optional(row) : std::nullopt;
        if (data.time[row] == data.time[row - 1]) {
            marks[row - 1] = false;
            repeated.push_back(row - 1);
        }
    }
    if (!wrong && 2 * repeated.size() > data.time.size()) {
        wrong = repeated.front() + 1;
    }
    if (wrong) {
        const SkippedRow row = describe(*wrong);
        return ReadError{row.line, row.column, row.text, {Fault::TimeNotRising}};
    }
    for (const std::size_t row : repeated) {
        leaveOut(describe(row), data.skipped);
    }
    if (!repeated.empty()) {
        std::ranges::stable_sort(data.skipped, {}, [](const SkippedRow &row) {
            return std::pair(row.fault == RowFault::NotListed, row.line);
        });
        keepRows(data, marks);
    }
    return std::nullopt;
}

/// Learns the step of encoders and converters, which is no power of ten, from the first rows.
void learnQuantum(ReferenceSeries &series, std::span<const double> time)
{
    constexpr std::size_t kLookedAt = 4096;
    const std::size_t rows = std::min(series.values.size(), kLookedAt);
    const auto values = std::span(series.values).first(rows);
    const double step = series.rounding.stepAt(rangeOf(values).size());
    const double slope = (values.back() - values.front()) / (time[rows - 1] - time[0]);
    bool isLine = true; // which is a comb, too, where the clock is even
    for (std::size_t row = 0; row < rows && isLine; ++row) {
        const double line = values.front() + slope * (time[row] - time[0]);
        isLine = std::abs(values[row] - line) <= 2.0 * step + 1e-9 * std::abs(line);
    }
    if (const std::optional<double> quantum = isLine ? std::nullopt : findQuantum(values, step)) {
        series.rounding.rule = Rounding::Rule::Multiples;
        series.rounding.quantum = *quantum / series.rounding.unitFactor;
    }
}

/// The columns without any number count as ignored.
void dropEmptySeries(ReferenceData &data)
{
    std::erase_if(data.series, [&](const ReferenceSeries &series) {
        const bool isEmpty = rangeOf(series.values).count == 0;
        for (FileColumn &column : data.layout.columns) {
            if (isEmpty && column.role == ColumnRole::Channel && column.channel == series.channel) {
                column.role = ColumnRole::Ignored;
                column.reason = ColumnReason::NoNumber;
            }
        }
        return isEmpty;
    });
}

/// Why there are no data at all.
std::optional<ReadError> findWhyUseless(const ReferenceData &data, std::size_t firstDataLine)
{
    if (!data.time.empty()) {
        return data.series.empty() ? std::optional(ReadError{firstDataLine, 0, {}, {Fault::NoValues}}) : std::nullopt;
    }
    if (data.skipped.empty()) {
        return ReadError{firstDataLine - 1, 0, {}, {Fault::NoNumbers}};
    }
    const SkippedRow &first = data.skipped.front();
    return ReadError{first.line, first.column, first.text, {.kind = Fault::NoRow, .row = first.fault}};
}

/// The data of files whose columns are settled; an error has no layout.
std::variant<ReferenceData, ReadError> assemble(std::vector<AssignedTable> &files, const FileLayout &layout)
{
    std::vector<SkippedRow> skipped;
    const std::vector<bool> marks = markRows(files, skipped);
    ReferenceData data = mergeColumns(files, layout);
    data.skipped = std::move(skipped);
    if (!data.skipped.empty()) {
        keepRows(data, marks);
    }
    std::optional<ReadError> error = joinInstants(data, files, marks);
    const AssignedTable &first = files.front();
    if (!error && !data.time.empty()) {
        const bool isByAngle = first.uses[first.abscissa].role == ColumnRole::CrankAngle;
        error = isByAngle ? countByAngle(data, first) : settleTime(data, first);
    }
    dropEmptySeries(data);
    if (!error) {
        error = findWhyUseless(data, first.table.firstDataLine);
    }
    if (error) {
        return *std::move(error);
    }
    for (ReferenceSeries &series : data.series) {
        learnQuantum(series, data.time);
    }
    for (FileColumn &column : data.layout.columns) {
        column.difference = column.role == ColumnRole::Channel ? differenceIn(data, column.channel) : std::nullopt;
    }
    return data;
}

/// Text and table of one file.
std::variant<RawTable, ReadError> readRaw(std::string_view bytes, const std::stop_token &stop,
                                          const std::function<void(std::size_t)> &progress)
{
    const std::variant<FileText, ReadError> text = decodeText(bytes);
    if (const ReadError *const error = std::get_if<ReadError>(&text)) {
        return *error;
    }
    const FileText &found = std::get<FileText>(text);
    std::variant<RawTable, ReadError> outcome = readTable(found.in(bytes), stop, progress);
    if (RawTable *const table = std::get_if<RawTable>(&outcome)) {
        table->layout.encoding = found.encoding;
        table->layout.byteOrderMark = found.byteOrderMark;
    }
    return outcome;
}

std::variant<ReferenceData, ReadError> readAll(std::span<const FileBytes> files, const std::stop_token &stop,
                                               const ReadOptions &options)
{
    std::size_t all = 0;
    for (const FileBytes &file : files) {
        all += file.bytes.size();
    }
    std::vector<AssignedTable> tables(files.size());
    std::optional<ReadError> error;
    std::size_t before = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::size_t size = files[i].bytes.size();
        const auto progress = [&](std::size_t done) {
            if (options.progress) {
                options.progress(before + std::min(done, size), all);
            }
        };
        std::variant<RawTable, ReadError> outcome = readRaw(files[i].bytes, stop, progress);
        before += size;
        if (stop.stop_requested()) {
            return ReadError{0, 0, {}, {Fault::Stopped}};
        }
        if (RawTable *const table = std::get_if<RawTable>(&outcome)) {
            tables[i].table = std::move(*table);
        } else if (!error) {
            error = std::get<ReadError>(std::move(outcome));
            error->file = i;
        }
    }
    FileLayout layout;
    if (std::optional<ReadError> refused = assignAll(tables, files, options, layout);
        refused && (!error || refused->file < error->file)) {
        error = std::move(refused);
    }
    if (files.size() == 1) {
        layout.files.clear();
    }
    if (!error) {
        std::variant<ReferenceData, ReadError> outcome = assemble(tables, layout);
        if (!std::holds_alternative<ReadError>(outcome)) {
            return outcome;
        }
        error = std::get<ReadError>(std::move(outcome));
    }
    error->file = files.size() == 1 ? std::nullopt : error->file;
    error->layout = std::move(layout);
    return *std::move(error);
}

} // namespace

const ReferenceSeries *ReferenceData::find(Channel channel) const
{
    const auto found = std::ranges::find(series, channel, &ReferenceSeries::channel);
    return found == series.end() ? nullptr : &*found;
}

std::size_t ReferenceData::skippedRowCount() const
{
    return std::accumulate(skipped.begin(), skipped.end(), std::size_t{0},
                           [](std::size_t count, const SkippedRow &row) { return count + row.rows; });
}

ValueRange rangeOf(std::span<const double> values)
{
    ValueRange range;
    for (const double value : values) {
        if (std::isfinite(value)) {
            range.low = std::min(range.low, value);
            range.high = std::max(range.high, value);
            ++range.count;
        }
    }
    return range;
}

ChannelSet channelsOf(const ReferenceData &data)
{
    ChannelSet channels;
    for (const ReferenceSeries &series : data.series) {
        channels.set(indexOf(series.channel));
    }
    return channels;
}

std::variant<ReferenceData, ReadError> readFiles(std::span<const FileBytes> files, std::stop_token stop,
                                                 const ReadOptions &options)
{
    try {
        return readAll(files, stop, options);
    } catch (const std::bad_alloc &) {
        return ReadError{0, 0, {}, {Fault::NoMemory}};
    }
}

std::variant<ReferenceData, ReadError> readReferenceData(std::string_view bytes, std::stop_token stop,
                                                         const ReadOptions &options)
{
    const FileBytes file{bytes};
    return readFiles({&file, 1}, std::move(stop), options);
}

} // namespace slidercrank
