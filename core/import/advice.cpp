// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/advice.h"

#include "core/import/cells.h"
#include "core/import/column_values.h"
#include "core/import/crank_angles.h"
#include "core/import/vocabulary.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <cmath>
#include <compare>

namespace slidercrank
{

namespace
{

using Fault = ReadFault::Kind;

/// Returns a choice of the column by its heading, or by its number if the heading is empty, not unique, or contains a
/// quotation mark. `unit`: empty for that of the file.
ColumnChoice choiceFor(const RawTable &table, const RawColumn &column, ColumnRole role, Channel channel = {},
                       std::string unit = {})
{
    const std::string &heading = column.use.heading;
    const auto hasHeading = [&](const RawColumn &other) { return other.use.heading == heading; };
    const bool isUnique =
        !heading.empty() && heading.find('"') == heading.npos && std::ranges::count_if(table.columns, hasHeading) == 1;
    return {column.index, role, channel, std::move(unit), isUnique ? heading : '#' + std::to_string(column.index + 1)};
}

/// Returns whether a column may contain the time stamps or crank angles: it is unused or the channel θ2, every cell has
/// a value, and the values only rise or only fall (those of an angle also after jumps by a turn). Its heading must not
/// name a different quantity, such as an error or a ratio.
bool mayBeAbscissa(const RawColumn &column)
{
    const bool isFree = !column.isUsed() || column.use.channel == kCrankAngle;
    return isFree && std::ranges::none_of(wordsOf(column.name), namesOtherQuantity) &&
           column.meaning.reason != ColumnReason::UnknownUnit && column.meaning.reason != ColumnReason::Ratio &&
           rangeOf(column.values).count == column.values.size() && column.values.size() > 1 &&
           (isTurningAngle(column) || (!isConstant(column) && !findReversal(column.values)));
}

/// Returns whether a column that may be the abscissa is probably an angle: its name or its unit says so or, without a
/// known unit, its values span more than a quarter turn in degrees.
bool looksLikeAngle(const RawColumn &column)
{
    constexpr double kQuarterTurn = 90.0;
    const std::optional<Unit> unit = parseUnit(column.use.unit);
    const bool isNamed =
        column.meaning.kind >= NameMeaning::Kind::Quantity && isAngle(column.meaning.channel.coordinate);
    return isNamed || (unit && unit->dimension == Dimension::Angle) ||
           (!unit && rangeOf(column.values).width() > kQuarterTurn);
}

/// Returns whether a column has a unit of angles and turns by more than half a turn in one direction, as only the crank
/// does.
bool makesTurnOfCrank(const RawColumn &column)
{
    const std::optional<Unit> unit = parseUnit(column.use.unit);
    const bool isAngle = unit && unit->dimension == Dimension::Angle && unit->order == 0;
    return isAngle && isTurningAngle(column) && makesHalfTurn(column);
}

/// Returns the quantity that a column probably is:
///
/// 1. the one that its name means, unless it has a known unit that does not suit this quantity,
/// 2. else the speed of the crank, if the unit leaves open whether it is in turns or radians,
/// 3. else the x of the slider, or its derivative, if the body is unknown and no unit is known,
/// 4. else the crank angle, if the values turn like the crank,
/// 5. else the angle of the coupler for a unit of angles, the x of the slider for other units, or their derivatives.
Channel likelyChannel(const RawColumn &column)
{
    const std::optional<Unit> unit = parseUnit(column.use.unit);
    const bool suits = !unit || parseColumnUnit(column.use.unit, ColumnRole::Channel, column.meaning.channel);
    if (column.meaning.kind >= NameMeaning::Kind::Quantity && suits) {
        return column.meaning.channel;
    }
    if (column.meaning.reason == ColumnReason::TurnsOrRadians) {
        return {Theta2, Order::Velocity};
    }
    if (column.meaning.reason == ColumnReason::UnknownBody && !unit) {
        return {R4x, column.meaning.channel.order};
    }
    if (makesTurnOfCrank(column)) {
        return kCrankAngle;
    }
    const bool isRate = unit && unit->dimension != Dimension::Time && unit->order <= 2;
    return {unit && unit->dimension == Dimension::Angle ? Theta3 : R4x,
            isRate ? static_cast<Order>(unit->order) : Order::Position};
}

/// Returns the unit to state for a column: rad/s for a speed in 1/s or Hz; empty if the unit of the file suits the
/// quantity; otherwise the default unit. `channel`: if the role is Channel.
std::string likelyUnit(const RawColumn &column, ColumnRole role, Channel channel)
{
    if (column.use.reason == ColumnReason::TurnsOrRadians) {
        return "rad/s";
    }
    if (parseColumnUnit(column.use.unit, role, channel)) {
        return {};
    }
    if (role == ColumnRole::Time) {
        return "s";
    }
    return std::string(fileUnit(role == ColumnRole::Channel ? channel : kCrankAngle));
}

/// Returns the unit to suggest for the time: s if its stated unit is unknown. If it states none, its numbers are too
/// large for seconds: ns if the rows would be far apart in µs, otherwise µs.
std::string likelyTimeUnit(const RawColumn &column)
{
    constexpr double kLongestInterval = 1e5; // µs between two rows
    const ValueRange range = rangeOf(column.values);
    if (!column.use.unit.empty()) {
        return "s";
    }
    return range.width() > kLongestInterval * static_cast<double>(range.count) ? "ns" : "us";
}

bool isChannel(const RawColumn &column)
{
    return column.use.role == ColumnRole::Channel;
}

/// Returns the choice of the column that already is the abscissa, or else of the first one that may be. Returns no
/// choice if there is none.
std::vector<ColumnChoice> abscissaChoice(const RawTable &table, std::span<RawColumn> columns)
{
    if (const RawColumn *const guessed = findElement(columns, &RawColumn::isAbscissa)) {
        return {choiceFor(table, *guessed, guessed->use.role, kCrankAngle)};
    }
    const RawColumn *const rising = findElement(columns, mayBeAbscissa);
    if (!rising) {
        return {};
    }
    const ColumnRole role = looksLikeAngle(*rising) ? ColumnRole::CrankAngle : ColumnRole::Time;
    return {choiceFor(table, *rising, role, kCrankAngle, likelyUnit(*rising, role, kCrankAngle))};
}

std::string withoutDigits(std::string heading)
{
    std::erase_if(heading, isDigit);
    return heading;
}

/// How likely a column is the channel that a person would choose: the greater, the likelier. Compared in this order.
struct Likelihood {
    bool isOpen = false;      ///< its heading leaves open which channel it is
    bool reverses = false;    ///< its values do not only rise or only fall
    bool isNotTurning = true; ///< it does not turn like the crank

    auto operator<=>(const Likelihood &) const = default;
};

/// Returns nullopt if a column cannot be a channel, because it is used, does not change, contains row numbers, further
/// time stamps or the crank pin, or has an unknown unit and a heading without a meaning.
std::optional<Likelihood> likelihoodOf(const RawColumn &column)
{
    const ColumnReason reason = column.use.reason;
    const bool isFree = !column.isUsed() && rangeOf(column.values).width() > 0.0 && reason != ColumnReason::RowNumber &&
                        reason != ColumnReason::SameTimeStamps && reason != ColumnReason::CrankPin;
    const bool hasUnit =
        column.use.unit.empty() || parseUnit(column.use.unit) || column.meaning.kind >= NameMeaning::Kind::Quantity;
    if (!isFree || !(leavesOpen(reason) || hasUnit)) {
        return std::nullopt;
    }
    return Likelihood{.isOpen = leavesOpen(reason),
                      .reverses = findReversal(column.values).has_value(),
                      .isNotTurning = !makesTurnOfCrank(column)};
}

/// Returns the first of the likeliest columns apart from the one with the index `excluded`; null if no column can be a
/// channel. If other columns of unknown bodies have the same heading apart from digits, they are points, and the last
/// one is returned: programs number points from the crank to the slider.
const RawColumn *likeliestChannel(std::span<const RawColumn> columns, std::size_t excluded)
{
    const auto likelihood = [excluded](const RawColumn &column) {
        return column.index == excluded ? std::nullopt : likelihoodOf(column);
    };
    const auto best = std::ranges::max_element(columns, {}, likelihood);
    if (best == columns.end() || !likelihood(*best)) {
        return nullptr;
    }
    const RawColumn *last = &*best;
    for (const RawColumn &other : columns) {
        const bool isPoint = likelihood(other) && other.use.reason == ColumnReason::UnknownBody &&
                             withoutDigits(other.use.heading) == withoutDigits(best->use.heading);
        last = isPoint ? &other : last;
    }
    return last;
}

/// Returns the choice of the likeliest channel, and those of the other quantities of the same point. Returns no choices
/// if no column may be a channel. `excluded`: index of a column that is not chosen.
std::vector<ColumnChoice> channelChoice(const RawTable &table, std::span<RawColumn> columns, std::size_t excluded)
{
    const RawColumn *const likeliest = likeliestChannel(columns, excluded);
    if (!likeliest) {
        return {};
    }
    const auto choice = [&table](const RawColumn &column) {
        const Channel channel = likelyChannel(column);
        return choiceFor(table, column, ColumnRole::Channel, channel, likelyUnit(column, ColumnRole::Channel, channel));
    };
    std::vector<ColumnChoice> choices{choice(*likeliest)};
    for (const RawColumn &other : columns) {
        const bool isOfSamePoint = !likeliest->meaning.owner.empty() && other.meaning.owner == likeliest->meaning.owner;
        const bool isOpen = other.index != excluded && likelihoodOf(other) && leavesOpen(other.use.reason);
        const auto isSameChannel = [&](const ColumnChoice &earlier) { return earlier.channel == likelyChannel(other); };
        if (isOfSamePoint && isOpen && std::ranges::none_of(choices, isSameChannel)) {
            choices.push_back(choice(other));
        }
    }
    return choices;
}

/// Returns the choices that ignore a second column of time stamps, and the columns behind it, which were sampled at
/// these times. If no column before it could be a channel, ignores only the second time.
std::vector<ColumnChoice> choicesIgnoring(const RawTable &table, std::span<const RawColumn> columns,
                                          const RawColumn &secondTime)
{
    const auto isQuantity = [](const RawColumn &column) { return column.meaning.kind >= NameMeaning::Kind::Quantity; };
    const auto second = static_cast<std::size_t>(&secondTime - columns.data());
    std::vector<ColumnChoice> choices{choiceFor(table, secondTime, ColumnRole::Ignored)};
    if (std::ranges::any_of(columns.first(second), isQuantity)) {
        for (const RawColumn &column : columns.subspan(second + 1)) {
            if (column.meaning.kind != NameMeaning::Kind::Nothing) {
                choices.push_back(choiceFor(table, column, ColumnRole::Ignored));
            }
        }
    }
    return choices;
}

} // namespace

std::vector<ColumnChoice> adviceFor(const ReadError &error, RawTable &table)
{
    if (table.columns.empty()) {
        return {};
    }
    const TableFile &file = table.files[std::min(error.file.value_or(0), table.files.size() - 1)];
    const std::span<RawColumn> columns = table.columnsOf(file);
    RawColumn *const faulty = error.column > 0 && error.column <= columns.size() ? &columns[error.column - 1] : nullptr;
    std::vector<ColumnChoice> advice;
    switch (error.fault.kind) {
    case Fault::NoChannel:
    case Fault::NoCertainChannel: return channelChoice(table, columns, table.columns.size());
    case Fault::NoTime:
    case Fault::NamesMissing:
        advice = abscissaChoice(table, columns);
        if (!advice.empty() && std::ranges::none_of(columns, isChannel)) {
            std::ranges::copy(channelChoice(table, columns, advice.front().column), std::back_inserter(advice));
        }
        return advice;
    case Fault::UnknownUnit:
    case Fault::UnknownTimeUnit: {
        const bool isTime = error.fault.kind == Fault::UnknownTimeUnit;
        const ColumnRole role = isTime ? ColumnRole::Time : ColumnRole::Channel;
        if (faulty) {
            const std::string unit = isTime ? likelyTimeUnit(*faulty) : std::string(fileUnit(error.fault.channel));
            advice.push_back(choiceFor(table, *faulty, role, error.fault.channel, unit));
        }
        return advice;
    }
    case Fault::TimeTwice: return faulty ? choicesIgnoring(table, columns, *faulty) : advice;
    case Fault::ChannelTwice: return faulty ? std::vector{choiceFor(table, *faulty, ColumnRole::Ignored)} : advice;
    case Fault::ChannelInBoth: {
        RawColumn *const second =
            findElement(columns, [&](const RawColumn &column) { return column.use.channel == error.fault.channel; });
        return second ? std::vector{choiceFor(table, *second, ColumnRole::Ignored)} : advice;
    }
    default: return {};
    }
}

} // namespace slidercrank
