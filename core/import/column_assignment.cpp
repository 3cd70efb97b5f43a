// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/column_assignment.h"

#include "core/import/crank_angles.h"
#include "core/import/unnamed_bodies.h"
#include "core/import/vocabulary.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
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

/// Converts the values to the default unit.
void convert(RawColumn &column, const Unit &unit)
{
    std::ranges::for_each(column.values, [&unit](double &value) { value = unit.toDefault(value); });
    column.factor = unit.toDefault(1.0);
}

// ---- Time and crank angle ----

/// Returns whether two columns contain the same time stamps, apart from the rounding errors of a unit conversion and
/// from rows without a value in one of them.
bool areSameTimes(const Values &x, const Values &y)
{
    constexpr double kRoundingError = 1e-15; // of a unit conversion
    return std::ranges::equal(x, y, [](double a, double b) {
        return !std::isfinite(a - b) || std::abs(a - b) <= kRoundingError * std::abs(a);
    });
}

/// Returns whether time stamps without a unit are in a smaller unit than seconds: whole numbers that begin below the
/// longest time of an experiment and exceed it.
bool areOfSmallUnit(const RawColumn &column)
{
    constexpr double kLongestTime = 1e8; // s, three years
    const ValueRange range = rangeOf(column.values);
    const auto isWhole = [](double value) { return !std::isfinite(value) || value == std::rint(value); };
    return column.use.unit.empty() && range.low < kLongestTime && range.high >= kLongestTime &&
           std::ranges::all_of(column.values, isWhole);
}

/// Time stamps of a clock, or in s, ms, µs or ns since 1970, count from the first row.
void countFromFirstRow(RawColumn &column)
{
    constexpr double kHalfDay = 43'200.0; // s: a clock may have twelve hours
    constexpr double kHour = 3'600.0;     // s: a clock without a date that starts below shows the time since the start
    constexpr double kEarliestSecond = 1.2e9; // since 1970: in 2008
    constexpr double kLatestSecond = 1e11;    // since 1970: larger numbers are in a smaller unit
    if (column.cells.isClock) {
        column.values = unwrapped(std::move(column.values), kHalfDay);
    }
    const double first = rangeOf(column.values).low;
    double scale = 1.0; // number of units in a second
    while (column.use.unit.empty() && first < kInfinity && first > kLatestSecond * scale) {
        scale *= 1000.0;
    }
    const bool isSince1970 = first >= kEarliestSecond && first < kInfinity;
    if (isSince1970 || (column.cells.isClock && (column.cells.hasDate || first >= kHour))) {
        column.origin = first / scale;
        column.factor /= scale;
        const double step = column.rounding.infer(column.factor, true).finestStep();
        std::ranges::for_each(column.values, [&](double &value) {
            value = (value - first) / scale;
            value = step > 0.0 ? step * std::rint(value / step) : value; // a double near 1.7e9 is off by 1e-7
        });
    }
}

/// Makes a column the time or the crank angle. If there is such a column already, in another file or for another
/// signal, both must contain the same.
void setAbscissa(RawTable &table, RawColumn &column, ColumnRole role, ColumnReason reason)
{
    const bool isTime = role == ColumnRole::Time;
    const std::optional<Unit> unit = column.unitAs(role);
    if (!unit || (isTime && areOfSmallUnit(column))) {
        throw faultIn(table, column,
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
    } else if (areSameTimes(first->values, column.values)) {
        column.use.reason = ColumnReason::SameTimeStamps;
    } else if (first->use.file == column.use.file) {
        throw faultIn(table, column, {Fault::TimeTwice});
    } else {
        throw ReadError{.fault = {Fault::OtherTimeStamps, {}, table.fileOf(*first).name}, .file = column.use.file};
    }
}

/// Returns whether a word or symbol denotes an angle.
bool namesAngle(const std::string &word)
{
    const WordMeaning *const symbol = findWord(word, WordUse::Symbol);
    const WordMeaning *const entry = symbol ? symbol : findWord(word, WordUse::Word);
    return entry && entry->dimension == Dimension::Angle;
}

/// Returns whether the values of a column only rise, but are no row numbers, and its name is unknown. Whole numbers
/// that rise evenly to 180 or more may be degrees, unless they have the unit of a time.
bool mayBeTime(const RawColumn &column)
{
    constexpr double kHalfTurn = 180.0;
    const Values values = column.finiteValues();
    const NameMeaning &meaning = column.meaning;
    const bool isUnknown =
        meaning.kind == Kind::Nothing ||
        (meaning.kind == Kind::Quantity && meaning.hasUnknownWords && meaning.doubt == NameMeaning::Doubt::None);
    const bool isQuantity = !isUnknown || meaning.reason == ColumnReason::UnknownBody || // "X_Value", but "J1_x"
                            std::ranges::any_of(wordsOf(column.name), namesAngle);       // and "θ/θmax"
    if (column.isUsed() || isQuantity || !column.unitAs(ColumnRole::Time) || values.size() < 2 ||
        !(values[0] < values[1]) || findReversal(values)) {
        return false;
    }
    const bool isWhole = std::ranges::all_of(values, [](double value) { return value == std::rint(value); });
    const bool mayBeNumber = column.use.heading.empty() || column.meaning.reason == ColumnReason::RowNumber;
    return !isWhole || !column.use.unit.empty() || (!mayBeNumber && values.back() < kHalfTurn);
}

/// Returns whether the values are 0, 1, 2, … or 1, 2, 3, …
bool countsRows(const RawColumn &column)
{
    const Values values = column.finiteValues();
    const double first = values.empty() ? kNone : values[0];
    bool counts = first == 0.0 || first == 1.0;
    for (std::size_t row = 0; row < values.size(); ++row) {
        counts = counts && values[row] == first + static_cast<double>(row);
    }
    return counts;
}

/// Returns whether the column may be the crank angle by its name and values.
bool turns(const RawColumn &column)
{
    return column.meaning.kind == Kind::Quantity && column.meaning.channel == Channel{Theta3, Order::Position} &&
           isTurningAngle(column);
}

bool isChosen(const RawColumn &column)
{
    return column.meaning.kind == Kind::Chosen;
}

/// Returns whether a person chose theta2 for the column, which is the crank angle where there is no time.
bool isChosenCrankAngle(const RawColumn &column)
{
    return isChosen(column) && column.isUndecided() && column.meaning.channel == kCrankAngle;
}

/// Returns whether the heading names the crank angle, so that it is no guess.
bool isNamedCrankAngle(const RawColumn &column)
{
    return !isChosen(column) && column.meaning.kind > Kind::Quantity && column.meaning.channel == kCrankAngle &&
           column.unitAs(ColumnRole::CrankAngle);
}

/// Returns the column of the file with the heading of the abscissa in another file, or null.
RawColumn *findSameHeading(std::span<RawColumn> columns, const RawColumn &abscissa)
{
    return findElement(columns, [&abscissa](const RawColumn &column) {
        return !isChosen(column) && column.use.heading == abscissa.use.heading;
    });
}

/// Returns whether a column may be the abscissa if it is the first one: it is no row number or parameter, and no count
/// of the rows beside a crank angle.
bool mayLead(const RawColumn &column, bool hasCrankAngle)
{
    const bool isNumber = column.use.heading.empty() || column.use.reason == ColumnReason::RowNumber;
    const bool isCount = hasCrankAngle && !turns(column) && countsRows(column);
    return !isChosen(column) && !isConstant(column) && !isCount && (!isNumber || mayBeTime(column));
}

/// Finds the abscissa of a file in which no column is named as the time:
///
/// 1. if another file has an abscissa, the column with the same heading,
/// 2. else the column that a person chose as the crank angle,
/// 3. else the first column that may lead, if its name is unknown and its values only rise: the time,
/// 4. else the column that is named as the crank angle,
/// 5. else the first column that may lead and is not of words, if it is an angle that does not change its direction, as
///    in "theta, x, v".
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
    const bool hasCrankAngle = named || findElement(columns, turns);
    RawColumn *const leading =
        findElement(columns, [&](const RawColumn &column) { return mayLead(column, hasCrankAngle); });
    RawColumn *const leadingNumbers = findElement(columns, [&](const RawColumn &column) {
        return mayLead(column, hasCrankAngle) && rangeOf(column.values).count > 0;
    });
    if (leading && mayBeTime(*leading)) {
        setAbscissa(table, *leading, ColumnRole::Time, ColumnReason::RisingValues);
    } else if (named) {
        setAbscissa(table, *named, ColumnRole::CrankAngle, named->meaning.reason);
    } else if (leadingNumbers && turns(*leadingNumbers)) {
        setAbscissa(table, *leadingNumbers, ColumnRole::CrankAngle, ColumnReason::AngleForTime);
    }
}

/// Removes the columns that do not meet a condition, unless none does, and sets the reason why they are ignored.
template <typename Condition>
void keepBetter(std::vector<RawColumn *> &columns, ColumnReason reason, const Condition &isBetter)
{
    if (std::ranges::any_of(columns, [&](const RawColumn *column) { return isBetter(*column); })) {
        removeColumns(columns, reason, [&](const RawColumn &column) { return !isBetter(column); });
    }
}

/// Finds the abscissa of each file that has none yet, by the names of the columns or else by their values.
void assignAbscissas(RawTable &table)
{
    const RawColumn *const chosen = table.abscissa();
    for (const TableFile &file : table.files) {
        std::vector<RawColumn *> times;
        for (RawColumn &column : table.columnsOf(file)) {
            if (column.meaning.kind == Kind::Time && column.isUndecided()) {
                times.push_back(&column);
            }
        }
        keepBetter(times, ColumnReason::UnknownUnit, [](const RawColumn &column) { // not "T (Nm)", next to the time
            return column.unitAs(ColumnRole::Time).has_value();
        });
        keepBetter(times, ColumnReason::NoNumber, [](const RawColumn &column) { // not a clock, next to the seconds
            return !column.cells.isClock && rangeOf(column.values).count > 0;
        });
        for (RawColumn *const column : times) {
            if (chosen && &table.fileOf(*chosen) == &file) {
                column->use.reason = ColumnReason::LikeOther;
            } else if (!table.abscissa() || table.abscissa()->use.role == ColumnRole::Time) {
                setAbscissa(table, *column, ColumnRole::Time, ColumnReason::KnownName);
            }
        }
        if (!file.hasAbscissa) {
            guessAbscissa(table, file);
        }
    }
}

// ---- Channels ----

/// Returns the error that two columns are the same channel.
ReadError sameChannelError(const RawTable &table, const RawColumn &first, const RawColumn &second)
{
    const Channel channel = first.use.channel;
    return first.use.file == second.use.file
               ? faultIn(table, second, {Fault::ChannelTwice, channel})
               : ReadError{.fault = {Fault::ChannelInBoth, channel, table.fileOf(first).name}, .file = second.use.file};
}

/// Returns the only column that has that heading, or else that heading apart from the unit, or else that number.
RawColumn &findColumn(RawTable &table, const std::string &name)
{
    const auto headingOf = [](const RawColumn &column) { return column.use.heading; };
    const auto nameOfColumn = [](const RawColumn &column) { return column.name; };
    const auto numberOf = [](const RawColumn &column) { return '#' + std::to_string(column.index + 1); };
    const auto find = [&](const auto &textOf) -> RawColumn * {
        if (std::ranges::count(table.columns, name, textOf) > 1) {
            throw ReadError{.fault = {Fault::SeveralColumns, {}, name}};
        }
        return findElement(table.columns, [&](const RawColumn &column) { return textOf(column) == name; });
    };
    RawColumn *column = find(headingOf);
    column = column ? column : find(nameOfColumn);
    column = column ? column : find(numberOf);
    if (!column) {
        throw ReadError{.fault = {Fault::NoSuchColumn, {}, name}};
    }
    return *column;
}

/// Gives the columns the meanings that a person chose. Of several choices for one column, the last one applies.
void applyChoices(RawTable &table, std::span<const ColumnChoice> choices)
{
    for (const ColumnChoice &choice : choices) {
        if (!choice.heading.empty()) {
            findColumn(table, choice.heading).choice = choice;
        } else if (choice.column < table.columns.size()) { // otherwise it is remembered from a file with more columns
            table.columns[choice.column].choice = choice;
        }
    }
    for (RawColumn &column : table.columns) {
        if (!column.choice) {
            continue;
        }
        const ColumnRole role = column.choice->role;
        column.meaning = {Kind::Chosen, column.choice->channel, ColumnReason::Chosen};
        column.use.reason = role == ColumnRole::Ignored ? ColumnReason::Chosen : ColumnReason::UnknownName;
        if (role == ColumnRole::Time || role == ColumnRole::CrankAngle) {
            setAbscissa(table, column, role, ColumnReason::Chosen);
        }
    }
}

/// Returns whether the coordinate is the same in every position of the mechanism.
bool isFixed(Coordinate coordinate)
{
    return coordinate == R1x || coordinate == R1y || coordinate == Theta1 || coordinate == Theta4 || coordinate == R4y;
}

/// Removes columns that consist of words, if others contain numbers. Channels that are called by their names stay.
void removeWords(std::vector<RawColumn *> &candidates)
{
    const auto areNumbers = [](const RawColumn *column) {
        const auto unreadable = std::ranges::count_if(column->values, [](double value) { return std::isinf(value); });
        return 2 * unreadable <= std::ssize(column->values);
    };
    if (std::ranges::any_of(candidates, areNumbers)) {
        removeColumns(candidates, ColumnReason::NoNumber, [&](const RawColumn &column) {
            return column.meaning.kind < Kind::ChannelName && !areNumbers(&column);
        });
    }
}

/// Returns the rounding step of the largest value.
double stepOf(const RawColumn &column)
{
    return column.rounding.infer(column.factor, false).stepAt(rangeOf(column.values).size());
}

bool areEqual(const Values &x, const Values &y, double tolerance)
{
    return std::ranges::equal(
        x, y, [&](double a, double b) { return std::abs(a - b) <= tolerance || !std::isfinite(a - b); });
}

/// Returns whether the values are those of a finer column in a different unit, up to the rounding of both.
bool isCoarserCopy(const RawColumn &column, const RawColumn &other)
{
    const double step = stepOf(column);
    const double otherStep = stepOf(other);
    const bool isCoarser = step > otherStep || (step == otherStep && column.index > other.index);
    return isCoarser && column.factor != other.factor && column.values.size() >= 2 &&
           areEqual(column.values, other.values, step);
}

/// Returns whether the column is the crank angle once more, in a different unit or of a second table beside the first.
bool repeatsCrankAngle(RawTable &table, const RawColumn &column)
{
    const RawColumn *const abscissa = table.abscissa();
    return abscissa && abscissa->use.role == ColumnRole::CrankAngle && column.meaning.channel == kCrankAngle &&
           areEqual(column.values, abscissa->values, std::max(stepOf(column), stepOf(*abscissa)));
}

/// Returns whether the column may be a length by its name, but has no unit and counts the rows.
bool isNumberOfRow(const RawColumn &column)
{
    const bool isUncertainLength = column.meaning.kind == Kind::Quantity && !isAngle(column.use.channel.coordinate);
    return isUncertainLength && column.use.unit.empty() && countsRows(column);
}

/// Removes the candidates that another one makes superfluous: "Position (in)" repeats "Position (mm)", and "Pos" counts
/// the rows beside "Slider mm".
void removeRepeated(std::vector<RawColumn *> &candidates)
{
    const std::vector<RawColumn *> all = candidates;
    const auto hasRival = [&all](const RawColumn &column, const auto &condition) {
        return std::ranges::any_of(all, [&](const RawColumn *other) {
            return other != &column && other->use.channel == column.use.channel && condition(*other);
        });
    };
    removeColumns(candidates, ColumnReason::LikeOther, [&](const RawColumn &column) {
        return hasRival(column, [&](const RawColumn &other) { return isCoarserCopy(column, other); });
    });
    removeColumns(candidates, ColumnReason::RowNumber, [&](const RawColumn &column) {
        return isNumberOfRow(column) && hasRival(column, [](const RawColumn &) { return true; });
    });
}

/// Replaces the coupler's angle at B, which Norton calls θ3, by the one at A. They differ by half a turn, in the
/// direction that brings the angle at A between -90° and 270°.
void measureAtA(RawColumn &column)
{
    constexpr double kHalfTurn = 180.0;
    column.values = unwrapped(std::move(column.values));
    const ValueRange range = rangeOf(column.values);
    column.origin = range.low + range.high > kHalfTurn ? kHalfTurn : -kHalfTurn;
    std::ranges::for_each(column.values, [&column](double &value) { value -= column.origin; });
}

/// Returns the columns that could be channels according to their names and units, in the default unit and with
/// the channel that they would be. Sets the reason of columns with unsuitable units.
std::vector<RawColumn *> findCandidates(RawTable &table)
{
    std::vector<RawColumn *> candidates;
    for (RawColumn &column : table.columns) {
        const NameMeaning &meaning = column.meaning;
        if (!column.isUndecided() || meaning.kind < Kind::Quantity) {
            continue;
        }
        const std::optional<Unit> unit = column.unitAs(ColumnRole::Channel, meaning.channel);
        if (!unit && meaning.kind >= Kind::ChannelName) {
            throw faultIn(table, column, {Fault::UnknownUnit, meaning.channel});
        }
        if (!unit) {
            column.use.reason = ColumnReason::UnknownUnit;
            continue;
        }
        convert(column, *unit);
        if (repeatsCrankAngle(table, column)) {
            column.use.reason = ColumnReason::LikeOther;
            continue;
        }
        if (meaning.isAtB) {
            measureAtA(column);
        }
        column.use.channel = meaning.channel;
        if (isFixed(meaning.channel.coordinate)) { // whose values nobody needs
            std::ranges::replace_if(
                column.values, [](double value) { return std::isinf(value); }, kNone);
        }
        candidates.push_back(&column);
    }
    removeWords(candidates);
    removeRepeated(candidates);
    return candidates;
}

/// Gives each channel to the candidate with the best evidence, if there is only one.
void assignChannels(RawTable &table)
{
    std::vector<RawColumn *> candidates = findCandidates(table);
    assignBodies(table, candidates);
    for (RawColumn *const column : candidates) {
        const Kind evidence = column->meaning.kind;
        const auto *const rival = findElement(candidates, [&](const RawColumn *other) {
            return other != column && other->use.channel == column->use.channel &&
                   compareEvidence(other->meaning, column->meaning) >= 0;
        });
        if (!rival) {
            column->use.role = ColumnRole::Channel;
            column->use.reason = column->meaning.reason;
        } else if (evidence >= Kind::ChannelName && (*rival)->meaning.kind == evidence) {
            throw sameChannelError(table, *column, **rival);
        } else {
            column->use.reason = ColumnReason::LikeOther;
        }
    }
}

/// Throws if the file lacks the time or a channel.
void requireData(RawTable &table, std::size_t file)
{
    const TableFile &own = table.files[file];
    const std::span<const RawColumn> columns = table.columnsOf(own);
    const auto isChannel = [](const RawColumn &column) { return column.use.role == ColumnRole::Channel; };
    if (own.hasAbscissa && std::ranges::any_of(columns, isChannel)) {
        return;
    }
    if (own.layout.headerLine == 0 && !own.rows.empty()) {
        throw ReadError{.line = own.rows.front().number, .fault = {Fault::NamesMissing}, .file = file};
    }
    ReadFault fault{own.hasAbscissa ? Fault::NoChannel : Fault::NoTime};
    const RawColumn *const open = findElement(columns, [](const RawColumn &column) {
        return leavesOpen(column.use.reason) || column.use.reason == ColumnReason::UnknownUnit ||
               column.use.reason == ColumnReason::CrankPin;
    });
    if (own.hasAbscissa && open) {
        const RawColumn *const other = findElement(table.columns, [&](const RawColumn &column) {
            return column.use.file != file && column.use.channel == open->use.channel;
        });
        if (open->use.reason == ColumnReason::LikeOther && other) {
            throw sameChannelError(table, *open, *other);
        }
        fault = {Fault::NoCertainChannel, {}, excerpt(open->use.heading), open->use.reason};
    }
    throw ReadError{.line = own.layout.headerLine, .fault = fault, .file = file};
}

/// Takes back that the paths of headings imply m and rad where the values are too large for that: no coupler swings by
/// more than a turn, no crank is sampled less than twice a turn, and hardly any slider moves by more than ten metres.
void checkImpliedUnits(RawTable &table)
{
    constexpr double kMaxTravel = 10.0;                  // m
    constexpr double kMaxSwing = 2.0 * std::numbers::pi; // rad
    constexpr double kMaxStep = std::numbers::pi;        // rad from row to row, on average
    const auto isImplied = [](const RawColumn &column) { return column.meaning.reason == ColumnReason::PathInSi; };
    const auto isTooLarge = [&](const RawColumn &column) {
        if (!isImplied(column) || column.meaning.channel.order != Order::Position) {
            return false;
        }
        const double width = rangeOf(column.values).width();
        if (!isAngle(column.meaning.channel.coordinate)) {
            return width > kMaxTravel;
        }
        const Values angles = column.finiteValues();
        return width > kMaxSwing && (findReversal(angles) || width > kMaxStep * static_cast<double>(angles.size()));
    };
    if (std::ranges::none_of(table.columns, isTooLarge)) {
        return;
    }
    for (RawColumn &column : table.columns) {
        if (isImplied(column)) {
            column.use.unit.clear();
            column.meaning.reason =
                column.meaning.kind >= Kind::Words ? ColumnReason::KnownName : ColumnReason::QuantityInName;
        }
    }
}

} // namespace

void assignColumns(RawTable &table, std::span<const ColumnChoice> choices)
{
    applyChoices(table, choices);
    correctMeanings(table);
    checkImpliedUnits(table);
    assignAbscissas(table);
    assignChannels(table);
    for (std::size_t file = 0; file < table.files.size(); ++file) {
        requireData(table, file);
    }
}

} // namespace slidercrank
