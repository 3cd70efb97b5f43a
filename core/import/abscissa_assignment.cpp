// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/abscissa_assignment.h"

#include "core/import/column_values.h"
#include "core/import/crank_angles.h"
#include "core/import/vocabulary.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;
using Kind = NameMeaning::Kind;
using Values = std::vector<double>;

/// Returns whether two abscissas contain the same values, apart from the rounding errors of a unit conversion and from
/// rows without a value in one of them.
bool haveSameValues(const Values &x, const Values &y)
{
    constexpr double kRoundingError = 1e-15; // of a unit conversion
    return std::ranges::equal(x, y, [](double a, double b) {
        return !std::isfinite(a - b) || std::abs(a - b) <= kRoundingError * std::abs(a);
    });
}

/// Returns whether times without a unit must be in a smaller unit than seconds: whole numbers that begin below the
/// longest time of an experiment and exceed it.
bool areTooLargeForSeconds(const RawColumn &column)
{
    constexpr double kLongestTime = 1e8; // s, three years
    const ValueRange range = rangeOf(column.values);
    const auto isWhole = [](double value) { return !std::isfinite(value) || value == std::rint(value); };
    return column.use.unit.empty() && range.low < kLongestTime && range.high >= kLongestTime &&
           std::ranges::all_of(column.values, isWhole);
}

/// Returns whether time stamps without a unit are in days, as spreadsheets count them from 1900 and MATLAB from the
/// year 0: dates from 2000 to 2100, in steps too short for seconds that began so long ago.
bool areDays(const RawColumn &column)
{
    constexpr double kFirstDay = 36'526.0;  // 1 January 2000, in spreadsheets
    constexpr double kCentury = 36'525.0;   // days
    constexpr double kYearZero = 693'960.0; // days between the origins of MATLAB and of spreadsheets
    constexpr double kLongestStep = 1e-4;   // days: nine seconds
    const ValueRange range = rangeOf(column.values);
    const auto isInCentury = [&range](double origin) {
        return range.low >= origin + kFirstDay && range.high < origin + kFirstDay + kCentury;
    };
    return column.use.unit.empty() && (isInCentury(0.0) || isInCentury(kYearZero)) &&
           range.width() < kLongestStep * static_cast<double>(range.count);
}

/// Returns the number that divides time stamps, already converted from their stated unit, to give seconds. It is 1 for
/// a stated unit. Without one, very large numbers are in ms, µs or ns since 1970, large ones may be in days since a
/// date, and others are in s.
double divisorToSeconds(const RawColumn &column)
{
    constexpr double kDay = 86'400.0;      // s
    constexpr double kLatestSecond = 1e11; // since 1970: larger numbers are in a smaller unit
    if (areDays(column)) {
        return 1.0 / kDay;
    }
    const double first = rangeOf(column.values).low;
    double divisor = 1.0;
    while (column.use.unit.empty() && first < kInfinity && first > kLatestSecond * divisor) {
        divisor *= 1000.0;
    }
    return divisor;
}

/// Removes the jumps of a clock at noon and midnight. Then, if the time stamps are times of day or times since a date,
/// subtracts the smallest one from all of them, and converts them to seconds. A clock without a date that begins below
/// an hour shows the time since the start.
void countFromFirstRow(RawColumn &column)
{
    constexpr double kHalfDay = 43'200.0;     // s: a clock may have twelve hours
    constexpr double kHour = 3'600.0;         // s
    constexpr double kEarliestSecond = 1.2e9; // since 1970: in 2008
    if (column.cells.isClock) {
        column.values = unwrapped(std::move(column.values), kHalfDay);
    }
    const double first = rangeOf(column.values).low;
    const bool isSince1970 = first >= kEarliestSecond && first < kInfinity;
    const bool showsTimeOfDay = column.cells.isClock && (column.cells.hasDate || first >= kHour);
    if (!areDays(column) && !isSince1970 && !showsTimeOfDay) {
        return;
    }
    const double divisor = divisorToSeconds(column);
    column.origin = first / divisor;
    column.factor /= divisor;
    const double step = column.rounding.infer(column.factor, RoundingObserver::Content::TimeStamps).finestStep();
    std::ranges::for_each(column.values, [&](double &value) {
        value = (value - first) / divisor;
        value = step > 0.0 ? step * std::rint(value / step) : value; // again, as a double near 1.7e9 is off by 1e-7
    });
}

/// Returns whether a word or symbol denotes an angle, a derivative of one, or a body.
bool namesAngleOrBody(const std::string &word)
{
    const WordMeaning *const symbol = findWord(word, WordUse::Symbol);
    const WordMeaning *const entry = symbol ? symbol : findWord(word, WordUse::Word);
    return entry && (entry->dimension == Dimension::Angle || entry->body);
}

/// Returns whether the name leaves open what the column contains: it has no meaning or, without any doubt about the
/// body, unknown words. "X_Value" leaves it open, but neither "J1_x", which is of an unknown body, nor "crank radius",
/// "θ/θmax", "t/T" and "% of cycle" do.
bool isNameOpen(const RawColumn &column)
{
    const NameMeaning &meaning = column.meaning;
    const bool isUnknown =
        meaning.kind == Kind::Nothing ||
        (meaning.kind == Kind::Quantity && meaning.hasUnknownWords && meaning.doubt == NameMeaning::Doubt::None);
    const std::vector<std::string> words = wordsOf(column.name);
    return isUnknown && meaning.reason != ColumnReason::UnknownBody && meaning.reason != ColumnReason::UnknownUnit &&
           meaning.reason != ColumnReason::Ratio && std::ranges::none_of(words, namesOtherQuantity) &&
           std::ranges::none_of(words, namesAngleOrBody);
}

/// Returns whether an unused column may be the time although its name leaves that open: its values only rise, it has a
/// unit of time or none, and it contains neither row numbers nor degrees. Whole numbers without a unit may be row
/// numbers if they count the rows, or if the heading is empty or names row numbers. They may be degrees if they reach
/// 180.
bool mayBeTime(const RawColumn &column)
{
    constexpr double kHalfTurn = 180.0;
    const Values values = column.finiteValues();
    const bool rises = values.size() > 1 && values[0] < values[1] && !findReversal(values);
    if (!rises || column.isUsed() || !isNameOpen(column) || !column.unitAs(ColumnRole::Time)) {
        return false;
    }
    const bool areWhole = std::ranges::all_of(values, [](double value) { return value == std::rint(value); });
    const bool mayBeRowNumbers =
        column.use.heading.empty() || column.meaning.reason == ColumnReason::RowNumber || countsRows(column);
    const bool mayBeDegrees = values.back() >= kHalfTurn;
    return !areWhole || !column.use.unit.empty() || (!mayBeRowNumbers && !mayBeDegrees);
}

/// Returns whether the name is that of an angle of an unnamed body, and the values only rise or only fall. If this is
/// the first column, it may be the crank angle.
bool mayBeCrankAngle(const RawColumn &column)
{
    const Channel channel = column.meaning.channel;
    return column.meaning.kind == Kind::Quantity && channel.order == Order::Position && isAngle(channel.coordinate) &&
           isTurningAngle(column);
}

/// Returns whether a column may be the crank angle even if it is not the first one, because it also spans more than
/// half a turn.
bool turnsLikeCrank(const RawColumn &column)
{
    return mayBeCrankAngle(column) && makesHalfTurn(column);
}

/// Returns whether a person chose the channel θ2 for the column. Where there is no time, this is the abscissa.
bool isChosenCrankAngle(const RawColumn &column)
{
    return isChosen(column) && column.isUndecided() && column.meaning.channel == kCrankAngle;
}

/// Returns whether the heading names the crank angle (not only "an angle") and has a unit of angles or none; false if a
/// person chose the column.
bool isNamedCrankAngle(const RawColumn &column)
{
    return namesChannel(column.meaning) && column.meaning.channel == kCrankAngle &&
           column.unitAs(ColumnRole::CrankAngle);
}

/// Returns the first column with the heading of `abscissa`, a column of another file; null if there is none. Columns
/// that a person chose are left out.
RawColumn *findSameHeading(std::span<RawColumn> columns, const RawColumn &abscissa)
{
    return findElement(columns, [&abscissa](const RawColumn &column) {
        return !isChosen(column) && column.use.heading == abscissa.use.heading;
    });
}

/// Returns whether a column counts in the search for the first column of a file. These do not: columns that a person
/// chose, equal values, row numbers and columns without a heading that cannot be the time, and, beside a crank angle,
/// counts of the rows.
bool countsAsFirst(const RawColumn &column, bool hasCrankAngle)
{
    const bool isNumber = column.use.heading.empty() || column.use.reason == ColumnReason::RowNumber;
    const bool isCount = hasCrankAngle && !mayBeCrankAngle(column) && countsRows(column);
    return !isChosen(column) && !isConstant(column) && !isCount && (!isNumber || mayBeTime(column));
}

/// Finds the abscissa of a file in which no column is named as the time:
///
/// 1. if another file has an abscissa, the column with the same heading,
/// 2. else the column that a person chose as the crank angle,
/// 3. else the first column that counts, if its name leaves its meaning open and its values only rise: the time,
/// 4. else the column that is named as the crank angle,
/// 5. else the first column that counts and contains numbers, if it is an angle that does not change its direction, as
///    in "theta, x, v",
/// 6. else the only column of an angle that makes half a turn without changing its direction, as in "x, v, angle".
void guessAbscissa(RawTable &table, const TableFile &file)
{
    const std::span<RawColumn> columns = table.columnsOf(file);
    if (const RawColumn *const other = table.abscissa()) {
        if (RawColumn *const same = findSameHeading(columns, *other)) {
            setAbscissa(table, *same, other->use.role, ColumnReason::KnownName);
        }
        return;
    }
    if (RawColumn *const chosen = findElement(columns, isChosenCrankAngle)) {
        return setAbscissa(table, *chosen, ColumnRole::CrankAngle, ColumnReason::Chosen);
    }
    RawColumn *const named = findElement(columns, isNamedCrankAngle);
    const bool hasCrankAngle = named || findElement(columns, mayBeCrankAngle);
    RawColumn *const firstColumn =
        findElement(columns, [&](const RawColumn &column) { return countsAsFirst(column, hasCrankAngle); });
    RawColumn *const firstWithNumbers = findElement(columns, [&](const RawColumn &column) {
        return countsAsFirst(column, hasCrankAngle) && rangeOf(column.values).count > 0;
    });
    if (firstColumn && mayBeTime(*firstColumn)) {
        setAbscissa(table, *firstColumn, ColumnRole::Time, ColumnReason::RisingValues);
    } else if (named) {
        setAbscissa(table, *named, ColumnRole::CrankAngle, named->meaning.reason);
    } else if (firstWithNumbers && mayBeCrankAngle(*firstWithNumbers)) {
        setAbscissa(table, *firstWithNumbers, ColumnRole::CrankAngle, ColumnReason::AngleForTime);
    } else if (std::ranges::count_if(columns, turnsLikeCrank) == 1) {
        setAbscissa(table, *findElement(columns, turnsLikeCrank), ColumnRole::CrankAngle, ColumnReason::AngleForTime);
    }
}

/// Returns the undecided columns of a file whose names denote a time, without these, whose reasons it sets:
///
/// 1. columns with other units ("T (Nm)"), if any column has a unit of time or none,
/// 2. times of a clock and columns without numbers, if any column contains numbers that are no times of a clock.
std::vector<RawColumn *> selectNamedTimes(RawTable &table, const TableFile &file)
{
    std::vector<RawColumn *> times;
    for (RawColumn &column : table.columnsOf(file)) {
        if (column.meaning.kind == Kind::Time && column.isUndecided()) {
            times.push_back(&column);
        }
    }
    const auto isUnitUnknown = [](const RawColumn &column) { return !column.unitAs(ColumnRole::Time); };
    if (!std::ranges::all_of(times, [&](const RawColumn *column) { return isUnitUnknown(*column); })) {
        removeColumns(times, ColumnReason::UnknownUnit, isUnitUnknown);
    }
    const auto isClock = [](const RawColumn &column) { return column.cells.isClock; };
    const auto isEmpty = [](const RawColumn &column) { return rangeOf(column.values).count == 0; };
    if (!std::ranges::all_of(times, [&](const RawColumn *column) { return isClock(*column) || isEmpty(*column); })) {
        removeColumns(times, ColumnReason::TimeOfDay, isClock);
        removeColumns(times, ColumnReason::NoNumber, isEmpty);
    }
    return times;
}

/// Uses the columns as the time, which must be the same in all of them. Ignores columns if a person chose the abscissa
/// of their file, or if the abscissa of another file is the crank angle.
void assignNamedTimes(RawTable &table, const std::vector<RawColumn *> &times)
{
    for (RawColumn *const column : times) {
        const RawColumn *const abscissa = table.abscissa();
        if (abscissa && isChosen(*abscissa) && abscissa->use.file == column->use.file) {
            column->use.reason = ColumnReason::LikeOther;
        } else if (!abscissa || abscissa->use.role == ColumnRole::Time) {
            setAbscissa(table, *column, ColumnRole::Time, ColumnReason::KnownName);
        }
    }
}

} // namespace

void setAbscissa(RawTable &table, RawColumn &column, ColumnRole role, ColumnReason reason)
{
    const bool isTime = role == ColumnRole::Time;
    const std::optional<Unit> unit = column.unitAs(role);
    if (!unit || (isTime && areTooLargeForSeconds(column))) {
        throw errorAtHeading(table, column,
                             isTime ? ReadFault{Fault::UnknownTimeUnit} : ReadFault{Fault::UnknownUnit, kCrankAngle});
    }
    convert(column, *unit);
    if (isTime) {
        countFromFirstRow(column);
    }
    table.files[column.use.file].hasAbscissa = true;
    const RawColumn *const first = table.abscissa();
    if (!first) {
        column.use.role = role;
        column.use.reason = reason;
    } else if (haveSameValues(first->values, column.values)) {
        column.use.reason = ColumnReason::SameTimeStamps;
    } else if (first->use.file == column.use.file) {
        throw errorAtHeading(table, column, {Fault::TimeTwice});
    } else {
        throw ReadError{.fault = {Fault::OtherTimeStamps, {}, table.fileOf(*first).name}, .file = column.use.file};
    }
}

void assignAbscissas(RawTable &table)
{
    for (const TableFile &file : table.files) {
        assignNamedTimes(table, selectNamedTimes(table, file));
        if (!file.hasAbscissa) {
            guessAbscissa(table, file);
        }
    }
}

} // namespace slidercrank
