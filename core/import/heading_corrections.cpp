// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading_corrections.h"

#include "core/import/column_values.h"

#include <algorithm>
#include <span>
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

/// Takes "α", which may also be an angular acceleration, as an angle if it makes half a turn.
void decideAlpha(std::span<RawColumn> columns)
{
    for (RawColumn &column : columns) {
        NameMeaning &meaning = column.meaning;
        if (meaning.doubt == Doubt::IsAngle && isTurningAngle(column) && makesHalfTurn(column)) {
            meaning.channel.order = Order::Position;
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

/// Returns whether the column is the angle of the link with the number 1, which makes half a turn.
bool isCrankWithNumberOne(const RawColumn &column)
{
    const Channel channel = column.meaning.channel;
    return namesChannel(column.meaning) && channel.order == Order::Position &&
           (channel.coordinate == Theta1 || (channel.coordinate == Theta2 && column.meaning.isFirstLink)) &&
           makesHalfTurn(column);
}

/// Returns the angle of the link with the next number.
Coordinate angleOfNextLink(Coordinate angle)
{
    if (angle == Theta1) {
        return Theta2;
    }
    return angle == Theta2 ? Theta3 : Theta4;
}

/// Renumbers the angles of the links if the crank has the number 1. Otherwise a θ1 that changes is not the angle of the
/// frame, and of an unknown body.
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

} // namespace

void correctMeanings(RawTable &table)
{
    moveToY(table.columns);
    decideAlpha(table.columns);
    renumberLinks(table.columns);
}

} // namespace slidercrank
