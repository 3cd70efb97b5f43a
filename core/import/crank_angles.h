// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables over the crank angle instead of the time, as in textbooks and engine software. The time stamps follow from the
// drive:
//
//     t = (θ2 - θ20) / ω2
//
// Positions at a crank angle do not depend on the drive, but time derivatives do.

#include "core/import/reference_data.h"
#include "core/mechanism/mechanism.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace slidercrank
{

inline constexpr Channel kCrankAngle{Theta2, Order::Position};

/// Removes jumps by whole turns, as in angles that are limited to one turn, and returns whether there were any. If a
/// jump would leave a change of more than `largestChange` turns, changes nothing: the angles are in a different unit.
/// `turn`: in the unit of the angles.
bool removeJumps(std::vector<double> &angles, double turn, double largestChange = 0.25);

/// Removes the jumps of angles that are limited to one turn: 359, 0, 1 becomes 359, 360, 361. Angles that already go in
/// one direction throughout are returned unchanged. The `turn` of a clock is half a day.
std::vector<double> unwrapped(std::vector<double> angles, double turn = 360.0);

/// Returns the angles of a table (°) before they were rounded, if these are whole or half degrees: a table in radians
/// usually has the angles 0°, 15°, 30° … Returns other angles unchanged, and angles with too few digits to tell.
std::vector<double> wholeDegreesBeforeRounding(std::vector<double> degrees, const Rounding &rounding);

/// Returns whether the values are points of a straight line over the time, apart from a tolerance.
bool isStraight(std::span<const double> values, std::span<const double> time, double tolerance);

/// Returns the index of the first value that does not continue in the direction of the first two, or nullopt.
std::optional<std::size_t> findReversal(std::span<const double> values);

/// Returns the data with the time stamps at which the crank of that mechanism has the angles of the file. Reverses the
/// order of the rows if it rotates in the opposite direction. Data with time stamps of their own are returned
/// unchanged. Returns nullopt if the crank stands still, or is so slow or fast that a double cannot distinguish the
/// time stamps.
std::optional<ReferenceData> timedBy(const Mechanism &mechanism, ReferenceData data);

} // namespace slidercrank
