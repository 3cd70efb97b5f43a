// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What of a curve of any number of samples a plot of so many pixels can show: at most two points a pixel column (the
// smallest and the largest value, in the order in which they occur), gaps kept, cut off at the axes. Units are those of
// the caller. A value that is not finite is a gap, written as kNoValue.

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

/// Which samples lie in which pixel column of a time range; shared by all curves over the same instants.
struct PixelColumns {
    std::size_t first = 0; ///< the samples to draw: those within the range and one neighbour on either side,
    std::size_t end = 0;   ///< so that the line reaches the edges

    /// Where the samples of each column begin, and behind the last the end. Empty when there are at most two samples a
    /// column: then all of them are drawn.
    std::vector<std::size_t> starts;
};

/// `time`: ascending. `columns`: at least 1.
PixelColumns pixelColumns(std::span<const double> time, const Interval &range, std::size_t columns);

/// Which of the ascending instants is nearest to t; there must be one.
std::size_t nearestIndex(std::span<const double> time, double t);

/// `values`: one for each of `time`.
std::vector<CurvePoint> decimate(std::span<const double> time, std::span<const double> values,
                                 const PixelColumns &columns);

/// The polyline without the points that lie within `tolerance` (in values) of the line between those that stay: a
/// smooth curve is drawn with a quarter of its lines. Gaps and the points beside them stay.
std::vector<CurvePoint> withoutNeedlessPoints(std::span<const CurvePoint> points, double tolerance);

/// The smallest and the largest value that is a number; nothing when there is none.
std::optional<Interval> extremes(std::span<const double> values);
std::optional<Interval> extremes(std::span<const CurvePoint> points);

/// Of the lines between the samples, within that range; `values`: one for each of `time`, or none at all.
std::optional<Interval> extremesWithin(std::span<const double> time, std::span<const double> values,
                                       const Interval &range);

/// The parts of the polyline within both ranges, cut exactly at the edges, with a gap between parts.
std::vector<CurvePoint> clip(std::span<const CurvePoint> points, const Interval &time, const Interval &values);

/// How long dashes are, and how many of the caller's length units one unit of t and of value takes.
struct DashPattern {
    double dash = 7.0;
    double gap = 6.0;
    double perT = 1.0;
    double perValue = 1.0;
};

/// The polyline cut into dashes; every part between gaps begins with one.
std::vector<CurvePoint> cutIntoDashes(std::span<const CurvePoint> points, const DashPattern &pattern);

/// Points that no line reaches because both neighbours are gaps.
std::vector<CurvePoint> isolatedPoints(std::span<const CurvePoint> points);

} // namespace slidercrank
