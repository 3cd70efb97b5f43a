// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Converts samples into the points that a plot of a given width in pixels can show. Units are those of the caller. A
// value that is not finite is a gap in the curve, stored as kNone.

#include "core/mechanism/mechanism.h"
#include "ui/text/interval.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

/// Replaces ∞. It is beyond the end of any axis, but finite, so that lines to it can be clipped.
inline constexpr double kBeyondAll = 1e300;

struct CurvePoint {
    double t = 0.0;
    double value = 0.0; ///< kNone for a gap
};

/// Returns the index of the time stamp nearest to t. Requires `time` to be ascending and not empty.
std::size_t nearestIndex(std::span<const double> time, double t);

/// Returns the samples within the range and one on either side of it, so that the line reaches the edges. If they are
/// more than two per pixel column, returns only the smallest, the largest and the first gap of each column. Requires
/// `time` to be ascending and `values` to have one value per time stamp.
std::vector<CurvePoint> decimate(std::span<const double> time, std::span<const double> values, const Interval &range,
                                 std::size_t columns);

/// Pixels per unit of the time and per unit of the values.
struct CurveScale {
    double time = 1.0;
    double value = 1.0;
};

/// Inserts points of the curve `valueAt` where the polyline through `points` is farther than `tolerance` (px) from the
/// curve, within the range `values`. At most 4095 points are inserted between two given ones.
std::vector<CurvePoint> refine(std::span<const CurvePoint> points, const std::function<double(double)> &valueAt,
                               const CurveScale &scale, double tolerance, const Interval &values);

/// Removes the points that lie within `tolerance` (in values) of the line between the remaining points. Gaps and the
/// points beside them are never removed.
std::vector<CurvePoint> withoutNeedlessPoints(std::span<const CurvePoint> points, double tolerance);

/// Returns the range of the values within the time range; nullopt if there are none. If `isUnbounded` is set or a value
/// is ±kBeyondAll, as near the limits of an oscillating crank, returns the range of the middle nine tenths of the
/// values.
std::optional<Interval> usualRange(std::span<const CurvePoint> points, const Interval &time, bool isUnbounded = false);

/// Returns the parts of the polyline within both ranges, cut exactly at the edges, with a gap between two parts.
std::vector<CurvePoint> clip(std::span<const CurvePoint> points, const Interval &time, const Interval &values);

/// Returns the points that lie alone between two gaps, so that no line leads to them.
std::vector<CurvePoint> isolatedPoints(std::span<const CurvePoint> points);

} // namespace slidercrank
