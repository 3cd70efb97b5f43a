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

enum class RowUse : char { Used, Unreadable, Repeated };

template <typename Value>
void removeUnused(std::vector<Value> &values, const std::vector<RowUse> &uses)
{
    std::size_t row = 0;
    std::erase_if(values, [&](const Value &) { return uses[row++] != RowUse::Used; });
}

/// Lists a skipped row, or counts it if the list is full.
void listSkipped(SkippedRow row, std::vector<SkippedRow> &skipped)
{
    if (skipped.size() > kListedRows) {
        ++skipped.back().rows;
    } else if (skipped.size() == kListedRows) {
        skipped.push_back({row.line, 0, {}, RowFault::NotListed, 1, row.file});
    } else {
        skipped.push_back(std::move(row));
    }
}

/// Returns the shortest text of the number.
std::string printedNumber(double value)
{
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// Returns the columns that have that heading, or else that heading apart from the unit, or else that number.
std::vector<std::size_t> columnsNamed(const std::string &name, const RawTable &table)
{
    std::array<std::vector<std::size_t>, 3> columns;
    for (const RawColumn &column : table.columns) {
        const std::array<std::string, 3> names{column.heading.printed, column.heading.name,
                                               '#' + std::to_string(column.index + 1)};
        const auto match = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
        if (match < names.size()) {
            columns[match].push_back(column.index);
        }
    }
    return !columns[0].empty() ? columns[0] : !columns[1].empty() ? columns[1] : columns[2];
}

/// Returns all choices by column number. Choices by heading override them.
std::vector<ColumnChoice> resolveChoices(const ReadOptions &options, const RawTable &table)
{
    std::vector<ColumnChoice> choices = options.columns;
    for (const NamedChoice &named : options.named) {
        const std::vector<std::size_t> columns = columnsNamed(named.heading, table);
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

bool isUsed(const RawColumn &column)
{
    return column.use.role != ColumnRole::Ignored;
}

/// Returns why a row is skipped: the first bad cell in a used column.
SkippedRow findFault(const RawTable &table, std::size_t row)
{
    for (std::size_t file = 0; file < table.files.size(); ++file) {
        const TableFile &own = table.files[file];
        for (auto bad = std::ranges::lower_bound(own.badCells, row, {}, &BadCell::row);
             bad != own.badCells.end() && bad->row == row; ++bad) {
            if (bad->spoilsRow || isUsed(table.columns[own.firstColumn + bad->column])) {
                return {own.lines[row], bad->column + 1, bad->text, bad->fault, 1, file};
            }
        }
    }
    const auto column = std::ranges::find_if(table.columns, [row](const RawColumn &each) {
        return isUsed(each) && (std::isinf(each.values[row]) || (each.isAbscissa() && std::isnan(each.values[row])));
    });
    const TableFile &own = table.fileOf(*column);
    const RowFault fault = std::isnan(column->values[row]) ? RowFault::NoTime : RowFault::TooLarge; // once converted
    return {own.lines[row], column->index - own.firstColumn + 1, {}, fault, 1, column->use.file};
}

/// Describes a row whose time is not above that of the row before.
SkippedRow timeFault(const RawTable &table, const RawColumn &time, std::size_t row)
{
    const TableFile &own = table.fileOf(time);
    return {own.lines[row],
            time.index - own.firstColumn + 1,
            printedNumber(time.values[row] / time.factor),
            RowFault::RepeatedTime,
            1,
            time.use.file};
}

/// Marks all but the last one of rows with the same time, as the last one contains the state after an event. Throws if
/// the time decreases, or if most rows repeat it.
void markRepeatedTimes(const RawTable &table, const RawColumn &time, std::vector<RowUse> &uses)
{
    std::optional<std::size_t> previous;
    std::optional<std::size_t> wrong;
    std::size_t repeated = 0;
    std::size_t count = 0;
    for (std::size_t row = 0; row < uses.size(); ++row) {
        if (uses[row] != RowUse::Used) {
            continue;
        }
        ++count;
        if (previous && time.values[row] <= time.values[*previous]) {
            wrong = wrong.value_or(row);
            if (time.values[row] < time.values[*previous]) {
                wrong = row;
                repeated = uses.size();
                break;
            }
            uses[*previous] = RowUse::Repeated;
            ++repeated;
        }
        previous = row;
    }
    if (wrong && 2 * repeated > count) {
        const SkippedRow row = timeFault(table, time, *wrong);
        throw ReadError{row.line, row.column, row.text, {Fault::TimeNotRising}};
    }
}

std::vector<RowUse> findUsedRows(RawTable &table)
{
    std::vector<RowUse> uses(table.files.front().lines.size(), RowUse::Used);
    for (const RawColumn &column : table.columns) {
        for (std::size_t row = 0; row < uses.size() && isUsed(column); ++row) {
            const double value = column.values[row];
            const bool isUnreadable = std::isinf(value) || (column.isAbscissa() && std::isnan(value));
            uses[row] = isUnreadable ? RowUse::Unreadable : uses[row];
        }
    }
    if (const RawColumn &abscissa = *table.abscissa(); abscissa.use.role == ColumnRole::Time) {
        markRepeatedTimes(table, abscissa, uses);
    }
    return uses;
}

/// Returns the used columns without the rows that are skipped. Tables by crank angle have the angles as time stamps.
ReferenceData collect(RawTable &table)
{
    ReferenceData data;
    const std::vector<RowUse> uses = findUsedRows(table);
    for (std::size_t row = 0; row < uses.size(); ++row) {
        if (uses[row] == RowUse::Unreadable) {
            listSkipped(findFault(table, row), data.skipped);
        } else if (uses[row] == RowUse::Repeated) {
            listSkipped(timeFault(table, *table.abscissa(), row), data.skipped);
        }
    }
    for (RawColumn &column : table.columns) {
        if (isUsed(column) && !data.skipped.empty()) {
            removeUnused(column.values, uses);
        }
        if (column.use.role == ColumnRole::Channel) {
            data.series.push_back({column.use.channel, std::move(column.values), column.rounding.infer(column.factor)});
        } else if (isUsed(column)) {
            data.time = std::move(column.values);
            data.timeRounding = column.rounding.inferForTimeStamps(column.factor);
        }
    }
    data.lines = std::move(table.files.front().lines);
    if (!data.skipped.empty()) {
        removeUnused(data.lines, uses);
    }
    return data;
}

/// Throws if there are no data.
void requireRows(const ReferenceData &data, std::size_t firstDataLine)
{
    if (!data.time.empty()) {
        return;
    }
    if (data.skipped.empty()) {
        throw ReadError{firstDataLine - 1, 0, {}, {Fault::NoNumbers}};
    }
    const SkippedRow &first = data.skipped.front();
    throw ReadError{first.line, first.column, first.text, {.kind = Fault::NoRow, .row = first.fault}};
}

/// Replaces the crank angles in ReferenceData::time by time stamps.
void countByAngle(ReferenceData &data, RawTable &table)
{
    data.crank.emplace();
    data.crank->degrees = unwrapped(data.time);
    data.crank->rounding = data.timeRounding;
    if (const std::optional<std::size_t> row = findReversal(data.crank->degrees)) {
        throw faultIn(table, *table.abscissa(), {Fault::AngleTurnsBack, {}, printedNumber(data.time[*row - 1]) + "°"});
    }
    std::optional<ReferenceData> timed = timedBy(Mechanism(), data);
    if (!timed) {
        throw faultIn(table, *table.abscissa(), {.kind = Fault::NoRow, .row = RowFault::TooLarge});
    }
    data = *std::move(timed);
}

/// Finds the step of an encoder or converter, which is not a power of ten, from the first rows.
void findStep(ReferenceSeries &series, std::span<const double> time)
{
    constexpr std::size_t kExaminedRows = 4096;
    const std::size_t rows = std::min(series.values.size(), kExaminedRows);
    const auto values = std::span(series.values).first(rows);
    const double step = series.rounding.stepAt(rangeOf(values).size());
    const double slope = (values.back() - values.front()) / (time[rows - 1] - time[0]);
    bool isLine = true; // with even time stamps, its values are also multiples of a step
    for (std::size_t row = 0; row < rows && isLine; ++row) {
        const double line = values.front() + slope * (time[row] - time[0]);
        isLine = std::abs(values[row] - line) <= 2.0 * step + 1e-9 * std::abs(line);
    }
    if (const std::optional<double> quantum = isLine ? std::nullopt : findQuantum(values, step)) {
        series.rounding.rule = Rounding::Rule::Multiples;
        series.rounding.quantum = *quantum / series.rounding.unitFactor;
    }
}

/// Ignores the columns that contain no number. Throws if no other is left.
void removeEmptySeries(ReferenceData &data, RawTable &table)
{
    for (RawColumn &column : table.columns) {
        const auto isEmpty = [&](const ReferenceSeries &series) {
            return series.channel == column.use.channel && rangeOf(series.values).count == 0;
        };
        if (column.use.role == ColumnRole::Channel && std::erase_if(data.series, isEmpty) > 0) {
            column.use.role = ColumnRole::Ignored;
            column.setReason(ColumnReason::NoNumber);
        }
    }
    if (data.series.empty()) {
        throw ReadError{table.files.front().firstDataLine, 0, {}, {Fault::NoValues}};
    }
}

/// Returns the data of a table whose columns have their roles.
ReferenceData toData(RawTable &table)
{
    ReferenceData data = collect(table);
    requireRows(data, table.files.front().firstDataLine);
    if (table.abscissa()->use.role == ColumnRole::CrankAngle) {
        countByAngle(data, table);
    }
    removeEmptySeries(data, table);
    for (ReferenceSeries &series : data.series) {
        findStep(series, data.time);
    }
    for (RawColumn &column : table.columns) {
        column.use.difference =
            column.use.role == ColumnRole::Channel ? differenceIn(data, column.use.channel) : std::nullopt;
    }
    return data;
}

/// Reads the tables of all files side by side. If only the beginnings of the files are known, they are cut to the
/// shortest one.
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
            if (before == 0) {
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
        std::ranges::for_each(table.files, [&](TableFile &file) { file.lines.resize(shortest); });
        std::ranges::for_each(table.columns, [&](RawColumn &column) { column.values.resize(shortest); });
    }
}

/// Returns the layout with what has become of the columns.
FileLayout toLayout(RawTable &table)
{
    std::ranges::transform(table.columns, std::back_inserter(table.layout.columns), &RawColumn::use);
    if (table.files.size() == 1) {
        table.layout.files.clear();
    }
    return std::move(table.layout);
}

/// Reads the files like readFiles(), but throws if there is not enough memory.
std::variant<ReferenceData, ReadError> readOrThrow(std::span<const FileBytes> files, const std::stop_token &stop,
                                                   const ReadOptions &options)
{
    RawTable table;
    try {
        readTables(files, stop, options, table);
        assignColumns(table, resolveChoices(options, table));
        ReferenceData data = toData(table);
        data.layout = toLayout(table);
        return data;
    } catch (ReadError &error) {
        error.file = files.size() == 1 ? std::nullopt : error.file;
        error.layout = toLayout(table);
        return std::move(error);
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

std::variant<ReferenceData, ReadError> readFiles(std::span<const FileBytes> files, const std::stop_token &stop,
                                                 const ReadOptions &options)
{
    try {
        return readOrThrow(files, stop, options);
    } catch (const std::bad_alloc &) {
        return ReadError{.fault = {Fault::NoMemory}};
    }
}

std::variant<ReferenceData, ReadError> readReferenceData(std::string_view bytes, const std::stop_token &stop,
                                                         const ReadOptions &options)
{
    const FileBytes file{bytes};
    return readFiles({&file, 1}, stop, options);
}

} // namespace slidercrank
