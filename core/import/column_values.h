// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the values of a column show.

#include "core/import/raw_table.h"

#include <cstddef>
#include <vector>

namespace slidercrank
{

/// The smallest number of rows from which conclusions are drawn: in fewer, values may be equal by chance.
inline constexpr std::size_t kMinConclusiveRows = 10;

/// The angle of the coupler spans less in every mechanism whose crank makes full turns, in degrees.
inline constexpr double kLargestSwing = 180.0;

/// Returns whether the readable values are equal; false for fewer than three, which may be equal by chance.
bool isConstant(const RawColumn &column);

/// Returns whether only one of at least ten rows has a value, as in the column of a parameter that is stated beside the
/// first row of the table.
bool isSingleValue(const RawColumn &column);

/// Returns whether the values, without gaps, are 0, 1, 2, … or 1, 2, 3, …
bool countsRows(const RawColumn &column);

/// Returns whether the column has a unit of angles or none, and its values, without the jumps after one turn, only rise
/// or only fall. The values of a count of turns, 0, 0, 0, 1, 1, do not.
bool isTurningAngle(const RawColumn &column);

/// Returns whether the column, whose values are still in the unit of the file, has a unit of angles or none and spans
/// more than half a turn.
bool makesHalfTurn(const RawColumn &column);

/// Returns whether at least ten values differ by no more than 1 % of the largest, which is not 0.
bool isNearlyConstant(const RawColumn &column);

} // namespace slidercrank
