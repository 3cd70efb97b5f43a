// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/reference_data.h"

#include "core/import/cells.h"
#include "core/import/column_assignment.h"
#include "core/import/crank_angles.h"
#include "core/import/difference.h"
#include "core/import/file_text.h"

#include <algorithm>
#include <array>
#include <charconv>
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

/// The shortest text of that number.
std::string printedNumber(double value)
{
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// The columns that a name may mean: those with that heading, else with that heading but for the unit, else the one of
/// that number.
std::vector<std::size_t> columnsNamed(const std::string &name, std::span<const Heading> headings)
{
    std::array<std::vector<std::size_t>, 3> columns;
    for (std::size_t i = 0; i < headings.size(); ++i) {
        const std::array<std::string, 3> names{headings[i].printed, headings[i].name, '#' + std::to_string(i + 1)};
        const auto match = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
        if (match < names.size()) {
            columns[match].push_back(i);
        }
    }
    return *std::ranges::find_if(columns,
                                 [&](const auto &found) { return !found.empty() || &found == &columns.back(); });
}

/// All choices by number: what is said of a heading overrides what was said of its number.
std::vector<ColumnChoice> resolveChoices(const ReadOptions &options, const RawTable &table)
{
    std::vector<ColumnChoice> choices = options.columns;
    for (const NamedChoice &named : options.named) {
        const std::vector<std::size_t> columns = columnsNamed(named.heading, table.headings);
        if (columns.size() != 1) {
            const std::size_t line = table.files.size() == 1 ? table.files[0].headerLine : 0;
            throw ReadError{
                line, 0, {}, {columns.empty() ? Fault::NoSuchColumn : Fault::SeveralColumns, {}, named.heading}};
        }
        std::erase_if(choices, [&](const ColumnChoice &choice) { return choice.column == columns.front(); });
        choices.push_back({columns.front(), named.role, named.channel, named.unit});
    }
    return choices;
}

bool isUsed(const FileColumn &column)
{
    return column.role != ColumnRole::Ignored;
}

/// Why the row cannot be used: the first cell at fault among those that are used.
SkippedRow findFault(const RawTable &table, std::size_t row)
{
    for (std::size_t file = 0; file < table.files.size(); ++file) {
        const TableFile &own = table.files[file];
        auto bad = std::ranges::lower_bound(own.badCells, row, {}, &BadCell::row);
        for (; bad != own.badCells.end() && bad->row == row; ++bad) {
            if (bad->spoilsRow || isUsed(table.layout.columns[own.firstColumn + bad->column])) {
                return {own.lines[row], bad->column + 1, bad->text, bad->fault, 1, file};
            }
        }
    }
    const auto isAtFault = [&](std::size_t i) {
        const double value = table.columns[i][row];
        return i == table.abscissa ? !std::isfinite(value) : isUsed(table.layout.columns[i]) && std::isinf(value);
    };
    std::size_t i = 0;
    while (!isAtFault(i)) {
        ++i;
    }
    const RowFault fault = std::isnan(table.columns[i][row]) ? RowFault::NoTime : RowFault::TooLarge;
    const TableFile &own = table.fileOf(i);
    return {own.lines[row], i - own.firstColumn + 1, {}, fault, 1, table.layout.columns[i].file};
}

/// The rows of all columns that are used, without those that cannot be.
ReferenceData collect(RawTable &table)
{
    ReferenceData data;
    std::vector<bool> marks(table.files.front().lines.size(), true);
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        for (std::size_t row = 0; row < marks.size() && isUsed(table.layout.columns[i]); ++row) {
            const double value = table.columns[i][row];
            marks[row] = marks[row] && !std::isinf(value) && !(i == table.abscissa && std::isnan(value));
        }
    }
    for (std::size_t row = 0; row < marks.size(); ++row) {
        if (!marks[row]) {
            leaveOut(findFault(table, row), data.skipped);
        }
    }
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const double factor = table.factors[i];
        if (table.layout.columns[i].role == ColumnRole::Channel) {
            data.series.push_back(
                {table.layout.columns[i].channel, std::move(table.columns[i]), table.roundings[i].infer(factor)});
        } else if (i == table.abscissa) {
            data.time = std::move(table.columns[i]);
            data.timeRounding = table.roundings[i].inferOfInstants(factor);
        }
    }
    data.lines = std::move(table.files.front().lines);
    data.layout = table.layout;
    if (!data.skipped.empty()) {
        keepRows(data, marks);
    }
    return data;
}

/// Makes time stamps of the crank angles that were read in their place.
void countByAngle(ReferenceData &data, const RawTable &table)
{
    data.crank.emplace();
    data.crank->degrees = goingOn(data.time);
    data.crank->rounding = data.timeRounding;
    if (const std::optional<std::size_t> row = turnsBackAt(data.crank->degrees)) {
        throw faultIn(table, *table.abscissa, {Fault::AngleTurnsBack, {}, printedNumber(data.time[*row - 1]) + "°"});
    }
    std::optional<ReferenceData> timed = timedBy(Mechanism(), data);
    if (!timed) {
        throw faultIn(table, *table.abscissa, {.kind = Fault::NoRow, .row = RowFault::TooLarge});
    }
    data = *std::move(timed);
}

/// Refuses a time that decreases. Of rows with the same time the last one is kept, as it holds the state after an
/// event; where most rows repeat the time, it is refused as well.
void settleTime(ReferenceData &data, const RawTable &table)
{
    const std::size_t abscissa = *table.abscissa;
    const auto describe = [&](std::size_t row) {
        return SkippedRow{data.lines[row], abscissa - table.fileOf(abscissa).firstColumn + 1,
                          printedNumber(data.time[row] / table.factors[abscissa]), RowFault::RepeatedTime};
    };
    std::vector<bool> marks(data.time.size(), true);
    std::vector<std::size_t> repeated;
    std::size_t wrong = 0; // row
    for (std::size_t row = 1; row < data.time.size() && wrong == 0; ++row) {
        wrong = data.time[row] < data.time[row - 1] ? row : 0;
        if (data.time[row] == data.time[row - 1]) {
            marks[row - 1] = false;
            repeated.push_back(row - 1);
        }
    }
    if (wrong == 0 && 2 * repeated.size() > data.time.size()) {
        wrong = repeated.front() + 1;
    }
    if (wrong > 0) {
        const SkippedRow row = describe(wrong);
        throw ReadError{row.line, row.column, row.text, {Fault::TimeNotRising}};
    }
    if (repeated.empty()) {
        return;
    }
    for (const std::size_t row : repeated) {
        leaveOut(describe(row), data.skipped);
    }
    std::ranges::stable_sort(
        data.skipped, {}, [](const SkippedRow &row) { return std::pair(row.fault == RowFault::NotListed, row.line); });
    keepRows(data, marks);
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

/// Throws where there are no data at all.
void requireData(const ReferenceData &data, std::size_t firstDataLine)
{
    if (data.time.empty() && data.skipped.empty()) {
        throw ReadError{firstDataLine - 1, 0, {}, {Fault::NoNumbers}};
    }
    if (data.time.empty()) {
        const SkippedRow &first = data.skipped.front();
        throw ReadError{first.line, first.column, first.text, {.kind = Fault::NoRow, .row = first.fault}};
    }
    if (data.series.empty()) {
        throw ReadError{firstDataLine, 0, {}, {Fault::NoValues}};
    }
}

/// The data of a table whose columns are settled.
ReferenceData assemble(RawTable &table)
{
    ReferenceData data = collect(table);
    if (!data.time.empty()) {
        const bool isByAngle = table.layout.columns[*table.abscissa].role == ColumnRole::CrankAngle;
        isByAngle ? countByAngle(data, table) : settleTime(data, table);
    }
    dropEmptySeries(data);
    requireData(data, table.files.front().firstDataLine);
    for (ReferenceSeries &series : data.series) {
        learnQuantum(series, data.time);
    }
    for (FileColumn &column : data.layout.columns) {
        column.difference = column.role == ColumnRole::Channel ? differenceIn(data, column.channel) : std::nullopt;
    }
    return data;
}

/// Text and table of all files, side by side. Files of which only the beginning is known are cut to the shortest.
void readTables(std::span<const FileBytes> files, const std::stop_token &stop, const ReadOptions &options,
                RawTable &table)
{
    const auto addSize = [](std::size_t sum, const FileBytes &file) { return sum + file.bytes.size(); };
    const std::size_t all = std::accumulate(files.begin(), files.end(), std::size_t{0}, addSize);
    std::size_t before = 0;
    std::size_t shortest = std::numeric_limits<std::size_t>::max();
    for (const FileBytes &file : files) {
        const std::size_t size = file.bytes.size();
        const auto progress = [&](std::size_t done) {
            if (options.progress) {
                options.progress(before + std::min(done, size), all);
            }
        };
        try {
            const FileText text = decodeText(file.bytes);
            readTable(text.in(file.bytes), file, stop, progress, table);
            if (&file == &files[0]) {
                table.layout.encoding = text.encoding;
                table.layout.byteOrderMark = text.byteOrderMark;
            }
        } catch (ReadError &error) {
            error.file = static_cast<std::size_t>(&file - files.data());
            throw;
        }
        before += size;
        shortest = std::min(shortest, table.files.back().lines.size());
    }
    if (std::ranges::any_of(files, &FileBytes::isBeginning)) {
        for (TableFile &file : table.files) {
            file.lines.resize(shortest);
        }
        for (std::vector<double> &column : table.columns) {
            column.resize(shortest);
        }
    }
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
    RawTable table;
    try {
        readTables(files, stop, options, table);
        assignColumns(table, resolveChoices(options, table));
        if (files.size() == 1) {
            table.layout.files.clear();
        }
        return assemble(table);
    } catch (const std::bad_alloc &) {
        return ReadError{.fault = {Fault::NoMemory}};
    } catch (ReadError &error) {
        if (files.size() == 1) {
            table.layout.files.clear();
            error.file.reset();
        }
        error.layout = std::move(table.layout);
        return std::move(error);
    }
}

std::variant<ReferenceData, ReadError> readReferenceData(std::string_view bytes, std::stop_token stop,
                                                         const ReadOptions &options)
{
    const FileBytes file{bytes};
    return readFiles({&file, 1}, std::move(stop), options);
}

} // namespace slidercrank
