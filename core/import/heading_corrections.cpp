// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading_corrections.h"

#include "core/import/column_values.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace slidercrank
{

namespace
{

using Kind = NameMeaning::Kind;
using Doubt = NameMeaning::Doubt;

/// Returns whether the slider moves along y, as in an upright engine: its y changes, and no column is its x.
bool isUpright(std::span<const RawColumn> columns)
{
    const auto isPosition = [](const RawColumn &column, Coordinate coordinate) {
        return column.meaning.kind >= Kind::Quantity && column.meaning.doubt == Doubt::None &&
               column.meaning.channel == Channel{coordinate, Order::Position};
    };
    const auto isMovingY = [&](const RawColumn &column) {
        return isPosition(column, R4y) && rangeOf(column.values).width() > 0.0;
    };
    const auto isX = [&](const RawColumn &column) { return isPosition(column, R4x); };
    return std::ranges::any_of(columns, isMovingY) && std::ranges::none_of(columns, isX);
}

/// Assigns velocities and accelerations of an upright slider to y if their names state no axis.
void moveToY(std::span<RawColumn> columns)
{
    if (!isUpright(columns)) {
        return;
    }
    for (RawColumn &column : columns) {
        NameMeaning &meaning = column.meaning;
        const bool mayBeY = (meaning.kind == Kind::Quantity || meaning.kind == Kind::Words) && !meaning.namesAxis;
        if (mayBeY && meaning.channel.coordinate == R4x && meaning.channel.order != Order::Position) {
            meaning.channel.coordinate = R4y;
        }
    }
}

/// Returns whether the name is θ1, θ2 or θ3, or a derivative, without a word for the body.
bool isOfNumberedLink(const RawColumn &column)
{
    const NameMeaning &meaning = column.meaning;
    const Coordinate coordinate = meaning.channel.coordinate;
    return namesChannel(meaning) && (meaning.kind == Kind::ChannelName || meaning.isNumberedLink) &&
           (coordinate == Theta1 || coordinate == Theta2 || coordinate == Theta3);
}

/// Returns whether the column is the angle of the link with the number 1, and spans more than half a turn. Then this
/// link is the crank.
bool isCrankWithNumberOne(const RawColumn &column)
{
    const Channel channel = column.meaning.channel;
    return namesChannel(column.meaning) && channel.order == Order::Position &&
           (channel.coordinate == Theta1 || (channel.coordinate == Theta2 && column.meaning.isFirstLink)) &&
           makesHalfTurn(column);
}

Coordinate angleOfNextLink(Coordinate angle)
{
    if (angle == Theta1) {
        return Theta2;
    }
    return angle == Theta2 ? Theta3 : Theta4;
}

/// Renumbers the angles of the links if the crank has the number 1. Otherwise, if θ1 changes, it is not the angle of
/// the frame, and its body is unknown.
void renumberLinks(std::span<RawColumn> columns)
{
    const bool isCrankFirst = std::ranges::any_of(columns, isCrankWithNumberOne);
    for (RawColumn &column : columns) {
        NameMeaning &meaning = column.meaning;
        if (!isOfNumberedLink(column)) {
            continue;
        }
        if (isCrankFirst) {
            meaning.channel.coordinate = angleOfNextLink(meaning.channel.coordinate);
            meaning.reason = ColumnReason::WideAngle;
        } else if (meaning.channel.coordinate == Theta1 && rangeOf(column.values).width() > 0.0) {
            meaning = {.reason = ColumnReason::UnknownBody};
        }
    }
}

/// Returns whether a column is an angle, or its derivative, without a stated unit.
bool isAngleWithoutUnit(const RawColumn &column)
{
    const bool isUnitChosen = column.choice && !column.choice->unit.empty();
    return column.isUndecided() && column.meaning.kind >= Kind::Quantity && column.use.unit.empty() && !isUnitChosen &&
           isAngle(column.meaning.channel.coordinate);
}

/// Returns whether the last value of a column is no farther from the first one than two neighbouring rows are from each
/// other, as in a table over a turn of the crank.
bool returnsToStart(const RawColumn &column)
{
    const std::vector<double> values = column.finiteValues();
    double largestChange = 0.0; // from row to row
    for (std::size_t i = 1; i < values.size(); ++i) {
        largestChange = std::max(largestChange, std::abs(values[i] - values[i - 1]));
    }
    return largestChange > 0.0 && std::abs(values.back() - values.front()) <= largestChange;
}

/// Returns whether the range of an angle, `width`, is a whole number of half turns in radians, apart from the rounding.
bool spansHalfTurns(double width, double roundingStep)
{
    constexpr double kMaxRoundingStep = 0.01; // with fewer decimals, many widths look like multiples of π
    const double rest = std::remainder(width, 0.5 * kTurn);
    return roundingStep <= kMaxRoundingStep && width > kMaxRoundingStep && std::abs(rest) <= roundingStep;
}

/// Returns whether an angle turns in one direction, and its values are those of radians, not of degrees. They jump by
/// 2π, or span some half turns, or stop less than a step before 2π while another column returns to its start:
///
///     0, 0.2618, … 6.0214, 0      0, 0.2618, … 6.2832      0, 0.1, … 6.2
bool turnsInRadians(const RawColumn &column, std::span<const RawColumn> columns)
{
    constexpr std::size_t kMinValues = 5;
    constexpr double kMaxWidth = 4.1 * kTurn; // rad: angles in degrees span more
    const std::vector<double> values = column.finiteValues();
    const double width = rangeOf(values).width();
    if (values.size() < kMinValues || width > kMaxWidth) {
        return false;
    }
    const double roundingStep = // the angle may be the abscissa
        column.rounding.infer(column.factor, RoundingObserver::Content::TimeStamps).stepAt(rangeOf(values).size());
    if (findReversal(values)) { // at a jump, or because the angle oscillates
        std::vector<double> unwrapped = values;
        const bool hasJumps = removeJumps(unwrapped, kTurn);
        return hasJumps && width <= kTurn + roundingStep && !findReversal(unwrapped);
    }
    const double step = width / static_cast<double>(values.size() - 1);
    const bool isNearlyTurn = width < kTurn && width + step > kTurn;
    const auto isOtherBackAtStart = [&column](const RawColumn &other) {
        return &other != &column && other.meaning.kind >= Kind::Quantity && returnsToStart(other);
    };
    return spansHalfTurns(width, roundingStep) || (isNearlyTurn && std::ranges::any_of(columns, isOtherBackAtStart));
}

/// Returns whether a column may be in radians beside an angle that is: an angle must not span more than one turn;
/// derivatives always may be.
bool mayBeInRadians(const RawColumn &column)
{
    return column.meaning.channel.order != Order::Position || rangeOf(column.values).width() <= kTurn;
}

/// Reads angles without a unit in radians if the values of one of them are those of radians.
void recognizeRadians(std::span<RawColumn> columns)
{
    const auto isEvidence = [columns](const RawColumn &column) {
        return isAngleWithoutUnit(column) && column.meaning.channel.order == Order::Position &&
               turnsInRadians(column, columns);
    };
    if (std::ranges::none_of(columns, isEvidence)) {
        return;
    }
    for (RawColumn &column : columns) {
        if (isAngleWithoutUnit(column) && (mayBeInRadians(column) || isEvidence(column))) {
            column.use.unit = "rad" + std::string(derivativeSuffix(column.meaning.channel.order));
            column.use.isInRadiansByValues = true;
        }
    }
}

} // namespace

void correctMeanings(RawTable &table)
{
    recognizeRadians(table.columns);
    moveToY(table.columns);
    renumberLinks(table.columns);
}

} // namespace slidercrank
