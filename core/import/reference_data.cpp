// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/reference_data.h"

#include "core/import/advice.h"
#include "core/import/column_assignment.h"
#include "core/import/crank_angles.h"
#include "core/import/difference.h"
#include "core/import/file_text.h"
#include "core/import/number_rows.h"
#include "core/import/unit_lines.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <new>
#include <utility>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;

ReadError errorAt(const SkippedRow &row, Fault fault)
{
    return {.line = row.line, .column = row.column, .text = row.text, .fault = {.kind = fault, .rowFault = row.fault}};
}

/// Returns whether a time or angle that turns back at `row` starts again there, as at the beginning of a second motion.
bool startsAgain(std::span<const double> values, std::size_t row)
{
    constexpr std::size_t kMinRows = 3;
    constexpr double kMaxDistance = 0.1; // from the first value, as a fraction of the range so far
    const double range = rangeOf(values.first(row)).width();
    return row >= kMinRows && std::abs(values[row] - values[0]) <= kMaxDistance * range;
}

bool areUnits(const Cells &cells)
{
    return std::ranges::all_of(cells, [](std::string_view cell) { return !unitIn(cell).empty(); });
}

/// Returns whether a line without numbers contains several headings, or units, that are not those of the columns.
bool beginsTable(const Cells &cells, std::span<const RawColumn> columns)
{
    std::size_t names = 0;
    bool hasOtherName = cells.size() != columns.size();
    bool hasOtherUnit = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string_view unit = unitIn(cells[i]);
        const FileColumn *const column = i < columns.size() ? &columns[i].use : nullptr;
        names += parseHeading(cells[i]).meaning.kind != NameMeaning::Kind::Nothing ? 1 : 0;
        hasOtherName = hasOtherName || !column || column->heading != cells[i];
        hasOtherUnit = hasOtherUnit || (column && parseUnit(unit) != parseUnit(column->unit));
    }
    const bool isOther = areUnits(cells) ? hasOtherUnit : names > 1 && hasOtherName; // "s" is a unit and a name
    return cells.size() > 1 && isOther;
}

/// Throws if another table begins in a file. A line that repeats the headings or units of the file is only skipped, and
/// a line below the last row of numbers is a remark, unless it contains units.
void refuseAnotherTable(const RawTable &table)
{
    for (const TableFile &file : table.files) {
        const std::span<const RawColumn> columns = std::span(table.columns).subspan(file.firstColumn, file.width);
        const auto hasNumber = [columns](std::size_t row) {
            return std::ranges::any_of(columns,
                                       [row](const RawColumn &column) { return std::isfinite(column.values[row]); });
        };
        std::size_t end = file.rows.size(); // index after the last row that contains a number
        while (end > 0 && !hasNumber(end - 1)) {
            --end;
        }
        for (std::size_t row = 0; row < file.rows.size(); ++row) {
            if (hasNumber(row)) {
                continue;
            }
            const Line &line = file.rows[row];
            const Cells cells = splitCells(line.text, file.layout.delimiter);
            if (beginsTable(cells, columns) && (row < end || areUnits(cells))) {
                throw ReadError{.line = line.number, .text = excerpt(line.text), .fault = {Fault::AnotherTable}};
            }
        }
    }
}

/// Returns the rows that can be read. Of rows with the same time, only the last one is used, as it contains the state
/// after an event; rows with the same crank angle are all used. Throws if the time decreases, or if most rows repeat
/// it.
std::vector<std::size_t> findUsedRows(RawTable &table)
{
    const RawColumn &abscissa = *table.abscissa();
    const std::vector<double> &time = abscissa.values;
    std::vector<std::size_t> rows;
    std::vector<std::size_t> repeated;
    for (std::size_t row = 0; row < time.size(); ++row) {
        if (std::ranges::any_of(table.columns, [row](const RawColumn &column) { return column.isUnreadable(row); })) {
            continue;
        }
        if (abscissa.use.role == ColumnRole::CrankAngle || rows.empty() || time[row] > time[rows.back()]) {
            rows.push_back(row);
        } else if (time[row] < time[rows.back()]) {
            throw errorAt(findRowFault(table, row),
                          startsAgain(time, row) ? Fault::TimeStartsAgain : Fault::TimeNotRising);
        } else {
            rows.back() = row;
            repeated.push_back(row);
        }
    }
    if (repeated.size() > rows.size()) {
        throw errorAt(findRowFault(table, repeated.front()), Fault::TimeNotRising);
    }
    return rows;
}

/// Counts the rows that are not used, except remarks, and lists the first ones.
void listSkippedRows(RawTable &table, const std::vector<std::size_t> &used, ReferenceData &data)
{
    constexpr std::size_t kListedRows = 1000;
    auto next = used.begin();
    const std::vector<Line> &lines = table.files.front().rows;
    for (std::size_t row = 0; row < lines.size(); ++row) {
        if (next != used.end() && *next == row) {
            ++next;
        } else if (!isRemark(lines[row].text) && ++data.skippedCount <= kListedRows) {
            data.skipped.push_back(findRowFault(table, row));
        }
    }
}

/// Returns the error of a file without any row that can be read. `row`: the first one that was skipped. If it has too
/// many cells, headings are missing (FewerHeadings), unless decimal commas may have divided its numbers: commas are the
/// delimiter, and the line contains no point. Otherwise the error is NoRow, with the fault of that row.
ReadError noRowError(const TableFile &file, const SkippedRow &row)
{
    const auto *const line = findElement(file.rows, [&row](const Line &other) { return other.number == row.line; });
    const bool mayHaveDecimalCommas =
        file.layout.delimiter == ',' && line && line->text.find('.') == std::string_view::npos;
    if (row.fault != RowFault::TooManyCells || !line || mayHaveDecimalCommas) {
        return errorAt(row, Fault::NoRow);
    }
    return {.line = row.line,
            .fault = {.kind = Fault::FewerHeadings,
                      .headingCount = file.width,
                      .cellCount = splitCells(line->text, file.layout.delimiter).size()}};
}

/// Throws if more rows with numbers are unreadable than can be read: a person would not expect that so little is used.
/// `used`: the rows that can be read.
void requireMostRows(RawTable &table, const std::vector<std::size_t> &used)
{
    std::vector<std::size_t> unreadable;
    for (std::size_t row = 0; row < table.abscissa()->values.size(); ++row) {
        const auto isUnreadable = [row](const RawColumn &column) {
            return column.isUsed() && std::isinf(column.values[row]);
        };
        const auto isRead = [row](const RawColumn &column) {
            return column.isUsed() && std::isfinite(column.values[row]);
        };
        if (std::ranges::any_of(table.columns, isUnreadable) && std::ranges::any_of(table.columns, isRead)) {
            unreadable.push_back(row);
        }
    }
    if (unreadable.size() > used.size()) {
        throw errorAt(findRowFault(table, unreadable.front()), Fault::MostRows);
    }
}

/// Moves the values of a used column to the data, in the rows that can be read: those of the abscissa to the time
/// stamps, those of a channel to a series. A channel without any number is ignored.
void moveValues(RawColumn &column, const std::vector<std::size_t> &rows, ReferenceData &data)
{
    std::vector<double> &values = column.values;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        values[i] = values[rows[i]];
    }
    values.resize(rows.size());
    const auto content =
        column.isAbscissa() ? RoundingObserver::Content::TimeStamps : RoundingObserver::Content::Quantity;
    const Rounding inferred = column.rounding.infer(column.factor, content);
    const Rounding rounding = column.origin == 0.0 ? inferred : inferred.withDecimalsAt(column.origin);
    if (column.isAbscissa()) {
        data.time = std::move(values);
        data.timeRounding = rounding;
    } else if (rangeOf(values).count > 0) {
        data.series.push_back({column.use.channel, std::move(values), rounding});
    } else {
        column.use.role = ColumnRole::Ignored;
        column.use.reason = ColumnReason::NoNumber;
    }
}

/// Returns the used columns without the rows that are skipped. In a table over the crank angle, the angles replace the
/// time stamps. Throws if no row or only a minority of the rows can be read, or if no channel has a number.
ReferenceData collect(RawTable &table)
{
    ReferenceData data;
    const std::vector<std::size_t> rows = findUsedRows(table);
    listSkippedRows(table, rows, data);
    const TableFile &file = table.files.front();
    if (rows.empty()) {
        throw data.skipped.empty() ? ReadError{.line = file.layout.headerLine, .fault = {Fault::NoNumbers}}
                                   : noRowError(file, data.skipped.front());
    }
    requireMostRows(table, rows);
    std::ranges::transform(rows, std::back_inserter(data.lines),
                           [&file](std::size_t row) { return file.rows[row].number; });
    for (RawColumn &column : table.columns) {
        if (column.isUsed()) {
            moveValues(column, rows, data);
        }
    }
    if (data.series.empty()) {
        throw ReadError{.line = file.rows.front().number, .fault = {Fault::NoValues}};
    }
    return data;
}

/// Returns the row at which the crank angle has its first value again, if the other columns differ there from those of
/// the first turn, so that a second motion begins. Otherwise returns nullopt.
std::optional<std::size_t> findAnotherMotion(const ReferenceData &data)
{
    constexpr double kMaxMeanDifference = 0.02; // of two turns of one motion, as a fraction of the column's range
    const std::vector<double> &angles = data.time;
    std::size_t rowsOfTurn = 1;
    while (rowsOfTurn < angles.size() && angles[rowsOfTurn] != angles[0]) {
        ++rowsOfTurn;
    }
    const std::size_t endOfSecondTurn = std::min(2 * rowsOfTurn, angles.size());
    const bool differs = std::ranges::any_of(data.series, [&](const ReferenceSeries &series) {
        double sum = 0.0;
        for (std::size_t i = rowsOfTurn; i < endOfSecondTurn; ++i) {
            sum += std::abs(series.values[i] - series.values[i - rowsOfTurn]);
        }
        return sum >
               kMaxMeanDifference * rangeOf(series.values).width() * static_cast<double>(endOfSecondTurn - rowsOfTurn);
    });
    return rowsOfTurn < angles.size() && differs ? std::optional(rowsOfTurn) : std::nullopt;
}

/// Replaces the crank angles in ReferenceData::time by time stamps. Throws if a second motion begins, or if the angle
/// turns back.
void replaceAnglesByTimes(ReferenceData &data, RawTable &table)
{
    if (const std::optional<std::size_t> row = findAnotherMotion(data)) {
        throw ReadError{.line = data.lineOfRow(*row), .fault = {Fault::AngleStartsAgain}};
    }
    data.crank = CrankAngles{wholeDegreesBeforeRounding(unwrapped(data.time), data.timeRounding), data.timeRounding};
    if (const std::optional<std::size_t> row = findReversal(data.crank->degrees)) {
        throw ReadError{.line = data.lineOfRow(*row),
                        .fault = {startsAgain(data.time, *row) ? Fault::AngleStartsAgain : Fault::AngleTurnsBack}};
    }
    std::optional<ReferenceData> timed = timedBy(Mechanism(), data);
    if (!timed) {
        throw errorAtHeading(table, *table.abscissa(), {.kind = Fault::NoRow, .rowFault = RowFault::TooLarge});
    }
    data = *std::move(timed);
}

constexpr double kArithmeticTolerance = 1e-9; // of a straight line or parabola, relative to the largest value

/// Returns the step of an encoder or converter whose values are printed within `uncertainty`. Returns nullopt if there
/// is none, or if the values are points of a straight line or parabola: with even time stamps, these are also multiples
/// of a step. `time`: one time stamp per value.
std::optional<double> findQuantumOfCurve(std::span<const double> values, std::span<const double> time,
                                         double uncertainty)
{
    const double tolerance = 2.0 * uncertainty + kArithmeticTolerance * rangeOf(values).size();
    const bool isSmooth = isStraight(values, time, tolerance) || isParabola(values, tolerance);
    return isSmooth ? std::nullopt : findQuantum(values, uncertainty);
}

/// Returns the step of an instrument, in the default unit, if the first rows of a series show one: that of an encoder
/// or converter, printed exactly (0.9°) or rounded (360°/1024), or else 5, 0.5 and the like, as of a scale.
std::optional<double> findInstrumentStep(const ReferenceSeries &series, std::span<const double> time)
{
    constexpr std::size_t kExaminedRows = 4096;
    constexpr double kMinQuantum = 1.5; // rounding steps: a smaller one is the rounding step itself
    const std::size_t rows = std::min(series.values.size(), kExaminedRows);
    const std::span<const double> firstTimes = time.first(rows);
    const auto firstValues = std::span(series.values).first(rows);
    std::vector<double> values(firstValues.begin(), firstValues.end());
    if (isAngle(series.channel.coordinate)) {
        values = unwrapped(std::move(values));
    }
    const double size = rangeOf(values).size();
    const double roundingStep = series.rounding.stepAt(size);
    const std::optional<double> exact = findQuantumOfCurve(values, firstTimes, 0.0);
    if (exact && *exact > kMinQuantum * roundingStep) {
        return exact;
    }
    if (const std::optional<double> rounded = findQuantumOfCurve(values, firstTimes, roundingStep)) {
        return rounded;
    }
    return isStraight(values, firstTimes, kArithmeticTolerance * size) ? std::nullopt
                                                                       : findStepOfFive(firstValues, series.rounding);
}

/// Returns whether prose can cause the fault of a file, and the file is prose.
bool isProseInsteadOfTable(const FileBytes &file, Fault fault)
{
    using enum ReadFault::Kind;
    constexpr std::array kFaultsThatProseCauses{UnitsContradict,  NamesMissing, MoreHeadings, FewerHeadings,
                                                AnotherTable,     TimeTwice,    NoTime,       NoChannel,
                                                NoCertainChannel, NoNumbers,    NoRow};
    std::string converted;
    return std::ranges::count(kFaultsThatProseCauses, fault) > 0 &&
           isProse(splitLines(decodeText(file.bytes, converted)));
}

/// Returns the data of a table whose columns have their roles. Throws ReadError.
ReferenceData toData(RawTable &table)
{
    ReferenceData data = collect(table);
    if (table.abscissa()->use.role == ColumnRole::CrankAngle) {
        replaceAnglesByTimes(data, table);
    }
    for (ReferenceSeries &series : data.series) {
        if (const std::optional<double> step = findInstrumentStep(series, data.time)) {
            series.rounding.rule = Rounding::Rule::Multiples;
            series.rounding.quantum = *step / series.rounding.unitFactor;
        }
    }
    for (RawColumn &column : table.columns) {
        column.use.difference =
            column.use.role == ColumnRole::Channel ? differenceIn(data, column.use.channel) : std::nullopt;
    }
    return data;
}

/// Removes the rows beyond the last one of the shortest file.
void cutToShortest(RawTable &table)
{
    const auto rowsIn = [](const TableFile &file) { return file.rows.size(); };
    const std::size_t shortest = rowsIn(*std::ranges::min_element(table.files, {}, rowsIn));
    std::ranges::for_each(table.files, [shortest](TableFile &file) { file.rows.resize(shortest); });
    std::ranges::for_each(table.columns, [shortest](RawColumn &column) { column.values.resize(shortest); });
}

/// Returns an error with the file that it is in, the layout of the table as far as it was read, and the choices of
/// columns that would help. `reading`: index of the file that was being read; the number of files if all were.
ReadError withLayoutAndAdvice(ReadError error, RawTable &table, std::span<const FileBytes> files, std::size_t reading)
{
    const bool areRead = reading == files.size();
    // An error about all files is examined in the last one.
    const std::size_t faulty = error.file.value_or(areRead && !files.empty() ? files.size() - 1 : reading);
    if (!files.empty() && isProseInsteadOfTable(files[faulty], error.fault.kind)) {
        error = ReadError{.fault = {Fault::NotATable}, .file = faulty};
    }
    if (!areRead) {
        error.file = reading;
    }
    if (files.size() == 1) {
        error.file.reset();
    }
    error.advice = adviceFor(error, table);
    error.layout = describeLayout(table);
    return error;
}

} // namespace

const ReferenceSeries *ReferenceData::find(Channel channel) const
{
    return findElement(series, [channel](const ReferenceSeries &candidate) { return candidate.channel == channel; });
}

ChannelSet channelsOf(const ReferenceData &data)
{
    ChannelSet channels;
    for (const ReferenceSeries &series : data.series) {
        channels.set(indexOf(series.channel));
    }
    return channels;
}

std::variant<ReferenceData, ReadError> readFiles(std::span<const FileBytes> files, const ReadOptions &options)
try {
    RawTable table;
    std::size_t file = 0; // index of the file that is being read; after the last one, the number of files
    try {
        for (; file < files.size(); ++file) {
            const auto progress = [&](double fraction) {
                return !options.progress ||
                       options.progress((static_cast<double>(file) + fraction) / static_cast<double>(files.size()));
            };
            readTable(files[file], progress, table);
        }
        if (std::ranges::any_of(files, &FileBytes::isBeginning)) {
            cutToShortest(table);
        }
        refuseAnotherTable(table);
        assignColumns(table, options.columns);
        ReferenceData data = toData(table);
        data.layout = describeLayout(table);
        return data;
    } catch (const ReadError &error) {
        return withLayoutAndAdvice(error, table, files, file);
    }
} catch (const std::bad_alloc &) {
    return ReadError{.fault = {Fault::NoMemory}};
}

} // namespace slidercrank
