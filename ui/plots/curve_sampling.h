// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Turns samples into the points that a plot of a given width in pixels can show. Units are those of the caller. A value
// that is not finite is a gap in the curve, written as kNoValue.

#include "ui/text/interval.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

struct CurvePoint {
    double t = 0.0;
    double value = 0.0; ///< kNoValue: a gap
};

/// The index of the time stamp nearest to t. `time` is ascending and not empty.
std::size_t nearestIndex(std::span<const double> time, double t);

/// The samples within the range and one on either side of it, so that the line reaches the edges. Of many samples, the
/// smallest, the largest and the first gap of each pixel column. `time` is ascending, `values` has a value for each.
std::vector<CurvePoint> decimate(std::span<const double> time, std::span<const double> values, const Interval &range,
                                 std::size_t columns);

/// The polyline without the points that lie within `tolerance` (in values) of the line between those that stay: a
/// smooth curve is drawn with a quarter of its lines. Gaps and the points beside them stay.
std::vector<CurvePoint> withoutNeedlessPoints(std::span<const CurvePoint> points, double tolerance);

/// The smallest and the largest finite value; nothing when there is none.
std::optional<Interval> extremes(std::span<const CurvePoint> points);

/// The finite value below which that part of the finite values lies. Requires a finite value.
double quantile(std::span<const CurvePoint> points, double part);

/// The parts of the polyline within both ranges, cut exactly at the edges, with a gap between parts.
std::vector<CurvePoint> clip(std::span<const CurvePoint> points, const Interval &time, const Interval &values);

/// Points that no line reaches because both neighbours are gaps.
std::vector<CurvePoint> isolatedPoints(std::span<const CurvePoint> points);

} // namespace slidercrank
