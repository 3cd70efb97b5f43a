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

/// Names the column of a plot that is alone in its file by the name of the file, where its heading says nothing.
void nameByFile(RawTable &table, const std::string &file)
{
    for (std::size_t i = 0; table.headings.size() == 2 && i < 2; ++i) {
        Heading &heading = table.headings[i];
        if (table.headings[1 - i].meaning.kind != NameMeaning::Kind::Time || !saysNothing(heading)) {
            continue;
        }
        Heading byFile = parseHeading(file.substr(0, file.find_last_of('.')));
        byFile.printed = heading.printed;
        byFile.unit = heading.unit.empty() ? byFile.unit : heading.unit;
        byFile.meaning = meaningOf(byFile);
        byFile.isFromFileName = true;
        const bool isChannel = byFile.meaning.kind == NameMeaning::Kind::Channel;
        if (byFile.meaning.kind == NameMeaning::Kind::Quantity ||
            (isChannel && factorTo(byFile.meaning.channel, byFile.unit))) {
            heading = std::move(byFile);
            table.layout.columns[i].unit = heading.unit;
        }
    }
}

/// Puts the columns of all files side by side. Files of which only the beginning is known are cut to the shortest.
JoinedTable join(std::vector<RawTable> tables, std::span<const FileBytes> files)
{
    JoinedTable joined;
    const auto countRows = [](const RawTable &table) { return table.lines.size(); };
    const std::size_t shortest = countRows(*std::ranges::min_element(tables, {}, countRows));
    const bool areBeginnings = std::ranges::any_of(files, &FileBytes::isBeginning);
    for (std::size_t file = 0; file < tables.size(); ++file) {
        RawTable &table = tables[file];
        nameByFile(table, files[file].name);
        const std::size_t before = joined.headings.size();
        joined.firstColumns.push_back(before);
        if (file == 0) {
            joined.layout = table.layout;
            joined.layout.columns.clear();
            joined.layout.rows.clear();
        }
        joined.layout.files.push_back(files[file].name);
        joined.layout.rows.resize(std::max(joined.layout.rows.size(), table.layout.rows.size()));
        for (std::size_t row = 0; row < table.layout.rows.size(); ++row) {
            joined.layout.rows[row].resize(before);
            std::ranges::move(table.layout.rows[row], std::back_inserter(joined.layout.rows[row]));
        }
        for (std::size_t i = 0; i < table.headings.size(); ++i) {
            joined.layout.columns.push_back(table.layout.columns[i]);
            joined.layout.columns.back().file = file;
            joined.headings.push_back(std::move(table.headings[i]));
            joined.columns.push_back(std::move(table.columns[i]));
            joined.columns.back().resize(areBeginnings ? shortest : countRows(table));
            joined.roundings.push_back(table.roundings[i]);
        }
        table.lines.resize(areBeginnings ? shortest : countRows(table));
    }
    joined.files = std::move(tables);
    return joined;
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
std::variant<std::vector<ColumnChoice>, ReadFault> resolveChoices(const ReadOptions &options,
                                                                  std::span<const Heading> headings)
{
    std::vector<ColumnChoice> choices = options.columns;
    for (const NamedChoice &named : options.named) {
        const std::vector<std::size_t> columns = columnsNamed(named.heading, headings);
        if (columns.size() != 1) {
            return ReadFault{columns.empty() ? Fault::NoSuchColumn : Fault::SeveralColumns, {}, named.heading};
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

/// Why the row cannot be used: the first cell at fault among those that are used; none where it can.
std::optional<SkippedRow> findFault(const JoinedTable &table, std::size_t row)
{
    for (std::size_t file = 0; file < table.files.size(); ++file) {
        const RawTable &own = table.files[file];
        for (const BadCell &bad : std::ranges::equal_range(own.badCells, row, {}, &BadCell::row)) {
            if (bad.spoilsRow || isUsed(table.layout.columns[table.firstColumns[file] + bad.column])) {
                return SkippedRow{own.lines[row], bad.column + 1, bad.text, bad.fault, 1, file};
            }
        }
    }
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::size_t file = table.layout.columns[i].file;
        const double value = table.columns[i][row];
        const bool isMissing = i == table.abscissa && std::isnan(value);
        if (isMissing || (isUsed(table.layout.columns[i]) && std::isinf(value))) {
            return SkippedRow{table.files[file].lines[row],
                              i - table.firstColumns[file] + 1,
                              {},
                              isMissing ? RowFault::NoTime : RowFault::TooLarge,
                              1,
                              file};
        }
    }
    return std::nullopt;
}

/// The rows of all columns that are used, without those that cannot be.
ReferenceData collect(JoinedTable &table)
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
        if (std::optional<SkippedRow> fault = marks[row] ? std::nullopt : findFault(table, row)) {
            leaveOut(*std::move(fault), data.skipped);
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
std::optional<ReadError> countByAngle(ReferenceData &data, const JoinedTable &table)
{
    data.crank.emplace();
    data.crank->degrees = goingOn(data.time);
    data.crank->rounding = data.timeRounding;
    if (const std::optional<std::size_t> row = turnsBackAt(data.crank->degrees)) {
        return table.faultIn(*table.abscissa, {Fault::AngleTurnsBack, {}, printedNumber(data.time[*row - 1]) + "°"});
    }
    std::optional<ReferenceData> timed = timedBy(Mechanism(), data);
    if (!timed) {
        ReadError error = table.faultIn(*table.abscissa, {.kind = Fault::NoRow, .row = RowFault::TooLarge});
        error.line = data.lines.front();
        return error;
    }
    data = *std::move(timed);
    return std::nullopt;
}

/// Refuses a time that decreases. Of rows with the same time the last one is kept, as it holds the state after an
/// event; where most rows repeat the time, it is refused as well.
std::optional<ReadError> settleTime(ReferenceData &data, const JoinedTable &table)
{
    const std::size_t file = data.layout.columns[*table.abscissa].file;
    const auto describe = [&](std::size_t row) {
        return SkippedRow{data.lines[row], *table.abscissa - table.firstColumns[file] + 1,
                          printedNumber(data.time[row] / table.factors[*table.abscissa]), RowFault::RepeatedTime};
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
std::variant<ReferenceData, ReadError> assemble(JoinedTable &table)
{
    ReferenceData data = collect(table);
    const std::size_t firstDataLine = table.files.front().firstDataLine;
    std::optional<ReadError> error;
    if (!data.time.empty()) {
        const bool isByAngle = table.layout.columns[*table.abscissa].role == ColumnRole::CrankAngle;
        error = isByAngle ? countByAngle(data, table) : settleTime(data, table);
    }
    dropEmptySeries(data);
    error = error ? error : findWhyUseless(data, firstDataLine);
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
    const auto addSize = [](std::size_t sum, const FileBytes &file) { return sum + file.bytes.size(); };
    const std::size_t all = std::accumulate(files.begin(), files.end(), std::size_t{0}, addSize);
    std::vector<RawTable> tables(files.size());
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
            tables[i] = std::move(*table);
        } else if (!error) {
            error = std::get<ReadError>(std::move(outcome));
            error->file = i;
        }
    }
    JoinedTable table = join(std::move(tables), files);
    if (!error) {
        const auto choices = resolveChoices(options, table.headings);
        const ReadFault *const fault = std::get_if<ReadFault>(&choices);
        error = fault ? ReadError{files.size() == 1 ? table.layout.headerLine : 0, 0, {}, *fault}
                      : assignColumns(table, std::get<std::vector<ColumnChoice>>(choices));
    }
    if (files.size() == 1) {
        table.layout.files.clear();
    }
    if (!error) {
        std::variant<ReferenceData, ReadError> outcome = assemble(table);
        if (!std::holds_alternative<ReadError>(outcome)) {
            return outcome;
        }
        error = std::get<ReadError>(std::move(outcome));
    }
    error->file = files.size() == 1 ? std::nullopt : error->file;
    error->layout = std::move(table.layout);
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
