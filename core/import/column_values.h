// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the values of a column tell about it.

#include "core/import/raw_table.h"

#include <cstddef>
#include <vector>

namespace slidercrank
{

/// The smallest number of rows from which conclusions are drawn: in fewer, values may be equal by chance.
inline constexpr std::size_t kMinConclusiveRows = 10;

/// Largest range of the angle of a coupler, in degrees, in every mechanism that makes full turns.
inline constexpr double kLargestSwing = 180.0;

/// Returns whether the readable values are equal; false for fewer than three, which may be equal by chance.
bool isConstant(const RawColumn &column);

/// Returns whether only one of at least ten rows has a value, as beside a table of which the first row also contains
/// parameters.
bool isSingleValue(const RawColumn &column);

/// Returns whether the values are 0, 1, 2, … or 1, 2, 3, …
bool countsRows(const RawColumn &column);

/// Returns whether the values only rise or only fall, as an angle does whose jumps after one turn are removed. A count
/// of the turns, 0, 0, 0, 1, 1, does not.
bool isTurningAngle(const RawColumn &column);

/// Returns whether the column, which has not been converted yet, may be an angle that spans more than half a turn.
bool makesHalfTurn(const RawColumn &column);

/// Returns whether at least ten values differ by no more than 1 % of the largest, which is not 0.
bool isNearlyConstant(const RawColumn &column);

} // namespace slidercrank
