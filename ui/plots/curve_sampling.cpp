// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/curve_sampling.h"

#include "core/mechanism/mechanism.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace slidercrank
{

namespace
{

bool isGap(const CurvePoint &point)
{
    return std::isnan(point.value);
}

enum class Beyond { Below, Above };

/// Cuts off the parts of the polyline where a coordinate is below or above an edge.
std::vector<CurvePoint> cutOff(std::vector<CurvePoint> points, double CurvePoint::*coordinate, Beyond beyond,
                               double edge)
{
    const auto isInside = [&](const CurvePoint &point) {
        return beyond == Beyond::Below ? point.*coordinate >= edge : point.*coordinate <= edge;
    };
    if (std::ranges::all_of(points, isInside)) {
        return points;
    }
    std::vector<CurvePoint> kept;
    kept.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const CurvePoint &to = points[i];
        const CurvePoint &from = points[i > 0 ? i - 1 : 0];
        if (isInside(from) != isInside(to) && !isGap(from) && !isGap(to)) {
            const double part = (edge - from.*coordinate) / (to.*coordinate - from.*coordinate);
            CurvePoint crossing{std::lerp(from.t, to.t, part), std::lerp(from.value, to.value, part)};
            crossing.*coordinate = edge;
            kept.push_back(crossing);
            if (isInside(from)) {
                kept.push_back({crossing.t, kNone});
            }
        }
        const bool isNeedlessGap = isGap(to) && (kept.empty() || isGap(kept.back()));
        if (isGap(to) ? !isNeedlessGap : isInside(to)) {
            kept.push_back(to);
        }
    }
    return kept;
}

} // namespace

std::size_t nearestIndex(std::span<const double> time, double t)
{
    assert(!time.empty());
    const auto index = static_cast<std::size_t>(std::ranges::lower_bound(time, t) - time.begin());
    const bool isPreviousNearer = index == time.size() || (index > 0 && t - time[index - 1] < time[index] - t);
    return isPreviousNearer ? index - 1 : index;
}

std::vector<CurvePoint> decimate(std::span<const double> time, std::span<const double> values, const Interval &range,
                                 std::size_t columns)
{
    assert(time.size() == values.size() && columns > 0);
    const auto indexOf = [&](auto position) { return static_cast<std::size_t>(position - time.begin()); };
    std::size_t next = indexOf(std::ranges::lower_bound(time, range.lower));
    const std::size_t end = std::min(time.size(), indexOf(std::ranges::upper_bound(time, range.upper)) + 1);
    next -= next > 0 ? 1 : 0; // the sample before the range
    const bool keepsAll = end - next <= 2 * columns;
    const auto columnOf = [&, scale = static_cast<double>(columns) / range.length()](std::size_t i) {
        return std::clamp(std::floor((time[i] - range.lower) * scale), 0.0, static_cast<double>(columns) - 1.0);
    };
    std::vector<CurvePoint> points;
    while (next < end) { // handles one pixel column or, if all samples are kept, one sample
        std::size_t lowest = next;
        std::size_t highest = next;
        std::size_t firstGap = end;
        const double column = columnOf(next);
        do {
            if (std::isfinite(values[next])) {
                lowest = values[next] >= values[lowest] ? lowest : next; // also replaces a NaN
                highest = values[next] <= values[highest] ? highest : next;
            } else {
                firstGap = std::min(firstGap, next);
            }
            ++next;
        } while (!keepsAll && next < end && columnOf(next) == column);
        std::array kept{lowest, highest, firstGap};
        std::ranges::sort(kept);
        const auto last = std::unique(kept.begin(), kept.end());
        for (auto i = kept.begin(); i != last && *i < end; ++i) {
            points.push_back({time[*i], std::isfinite(values[*i]) ? values[*i] : kNone});
        }
    }
    return points;
}

namespace
{

/// Inserts further points of a curve between two given ones.
struct CurveRefinement {
    const std::function<double(double)> &valueAt;
    CurveScale scale;
    double tolerance;                 ///< px
    Interval values;                  ///< the visible range
    std::vector<CurvePoint> &refined; ///< receives the points

    /// Returns the distance (px) of a point from the line through two others.
    double distance(const CurvePoint &point, const CurvePoint &from, const CurvePoint &to) const
    {
        const double dx = scale.time * (to.t - from.t);
        const double dy = scale.value * (to.value - from.value);
        const double x = scale.time * (point.t - from.t);
        const double y = scale.value * (point.value - from.value);
        return std::abs(dx * y - dy * x) / std::hypot(dx, dy);
    }

    /// Appends the points that the curve needs between two given ones.
    void insertBetween(const CurvePoint &from, const CurvePoint &to, int depth)
    {
        constexpr int kMaxDepth = 12; // at most 2^12 - 1 points between two given ones
        const bool areBothBelow = from.value < values.lower && to.value < values.lower;
        const bool areBothAbove = from.value > values.upper && to.value > values.upper;
        if (depth == kMaxDepth || areBothBelow || areBothAbove) {
            return;
        }
        const auto pointAt = [&](double part) {
            const double t = std::lerp(from.t, to.t, part);
            return CurvePoint{t, valueAt(t)};
        };
        const CurvePoint middle = pointAt(0.5);
        // The second point detects a curve that crosses the line in the middle.
        const bool isCurved = distance(middle, from, to) > tolerance || distance(pointAt(0.25), from, to) > tolerance;
        if (std::isfinite(middle.value) && isCurved) {
            insertBetween(from, middle, depth + 1);
            refined.push_back(middle);
            insertBetween(middle, to, depth + 1);
        }
    }
};

} // namespace

std::vector<CurvePoint> refine(std::span<const CurvePoint> points, const std::function<double(double)> &valueAt,
                               const CurveScale &scale, double tolerance, const Interval &values)
{
    std::vector<CurvePoint> refined;
    refined.reserve(2 * points.size());
    CurveRefinement refinement{
        .valueAt = valueAt, .scale = scale, .tolerance = tolerance, .values = values, .refined = refined};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0 && !isGap(points[i - 1]) && !isGap(points[i])) {
            refinement.insertBetween(points[i - 1], points[i], 0);
        }
        refined.push_back(points[i]);
    }
    return refined;
}

// Starting at the last point that was kept, the lines that pass all later points within the tolerance form a fan of
// slopes. Each further point narrows this fan. When a point lies outside the fan, the point before it is kept, and a
// new fan starts there.
std::vector<CurvePoint> withoutNeedlessPoints(std::span<const CurvePoint> points, double tolerance)
{
    std::vector<CurvePoint> kept;
    kept.reserve(points.size());
    Interval fan{-kInfinity, kInfinity};
    const CurvePoint *before = nullptr; // within the fan, not kept yet
    const auto keepBefore = [&] {
        if (before) {
            kept.push_back(*before);
        }
        before = nullptr;
        fan = {-kInfinity, kInfinity};
    };
    for (const CurvePoint &point : points) {
        if (std::isnan(point.value) || kept.empty() || std::isnan(kept.back().value)) {
            keepBefore();
            kept.push_back(point);
            continue;
        }
        const auto slopeTo = [&](double value) { return (value - kept.back().value) / (point.t - kept.back().t); };
        if (before && !fan.contains(slopeTo(point.value))) {
            keepBefore();
        }
        fan.lower = std::max(fan.lower, slopeTo(point.value - tolerance));
        fan.upper = std::min(fan.upper, slopeTo(point.value + tolerance));
        before = &point;
    }
    keepBefore();
    return kept;
}

std::optional<Interval> usualRange(std::span<const CurvePoint> points, const Interval &time, bool isUnbounded)
{
    constexpr double kLeftOut = 0.05; // fraction of the values that is left out at either end
    std::vector<double> values;
    values.reserve(points.size());
    for (const CurvePoint &point : clip(points, time, {-kBeyondAll, kBeyondAll})) {
        if (std::abs(point.value) < kBeyondAll) {
            values.push_back(point.value);
        } else {
            isUnbounded |= !isGap(point);
        }
    }
    if (values.empty()) {
        return std::nullopt;
    }
    const auto leftOut = static_cast<std::ptrdiff_t>(isUnbounded ? kLeftOut * static_cast<double>(values.size()) : 0.0);
    const auto valueInOrder = [&values](auto position) {
        std::ranges::nth_element(values, position);
        return *position;
    };
    return Interval{valueInOrder(values.begin() + leftOut), valueInOrder(values.end() - 1 - leftOut)};
}

std::vector<CurvePoint> clip(std::span<const CurvePoint> points, const Interval &time, const Interval &values)
{
    std::vector<CurvePoint> kept = cutOff({points.begin(), points.end()}, &CurvePoint::t, Beyond::Below, time.lower);
    kept = cutOff(std::move(kept), &CurvePoint::t, Beyond::Above, time.upper);
    kept = cutOff(std::move(kept), &CurvePoint::value, Beyond::Below, values.lower);
    return cutOff(std::move(kept), &CurvePoint::value, Beyond::Above, values.upper);
}

std::vector<CurvePoint> isolatedPoints(std::span<const CurvePoint> points)
{
    std::vector<CurvePoint> isolated;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool hasGapBefore = i == 0 || isGap(points[i - 1]);
        const bool hasGapAfter = i + 1 == points.size() || isGap(points[i + 1]);
        if (!isGap(points[i]) && hasGapBefore && hasGapAfter) {
            isolated.push_back(points[i]);
        }
    }
    return isolated;
}

} // namespace slidercrank
