// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a sequence of values shows: its range, its direction, jumps of an angle, and whether its points are on a
// straight line or a parabola. None of these functions knows what the values mean.

#include "core/mechanism/mechanism.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

/// The range of the finite values in a sequence.
struct ValueRange {
    double low = kInfinity;
    double high = -kInfinity;
    std::size_t count = 0; ///< number of finite values

    void include(double value)
    {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
            ++count;
        }
    }
    double width() const { return high - low; }                 ///< -infinity without values
    double size() const { return std::max({0.0, -low, high}); } ///< the largest magnitude
};

ValueRange rangeOf(std::span<const double> values);

/// Returns the index of the first value that does not continue in the direction of the first two, or nullopt.
std::optional<std::size_t> findReversal(std::span<const double> values);

/// Returns whether the values at the times `time` are points of a straight line through the first and the last one,
/// apart from a tolerance. Requires at least one value.
bool isStraight(std::span<const double> values, std::span<const double> time, double tolerance);

/// Returns whether the values of evenly spaced rows are points of a parabola, apart from a tolerance.
bool isParabola(std::span<const double> values, double tolerance);

/// Removes jumps by whole turns, as in angles that are limited to one turn, and returns whether there were any. If a
/// change larger than `largestChange` turns remained at a jump, the angles are in a different unit: then changes
/// nothing and returns false. `turn`: a turn in the unit of the angles.
bool removeJumps(std::vector<double> &angles, double turn, double largestChange = 0.25);

/// Returns angles without the jumps after one turn: 359, 0, 1 becomes 359, 360, 361. Angles that go in one direction
/// throughout are returned unchanged. `turn`: a turn in the unit of the angles; half a day for the times of a clock.
std::vector<double> unwrapped(std::vector<double> angles, double turn = 360.0);

/// Returns the range of angles in degrees, without the jumps after one turn.
double angularWidth(std::vector<double> degrees);

} // namespace slidercrank
