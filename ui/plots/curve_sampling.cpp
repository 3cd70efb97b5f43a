// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/curve_sampling.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns the part of the line from `start` to `start + step` that lies within the range; 0 is its start, 1 its end.
/// An upper end below the lower one means that no part does. This is the test of one pair of parallel edges by Liang
/// and Barsky, A new concept and method for line clipping, 1984.
Interval partWithin(double start, double step, const Interval &range)
{
    if (step == 0.0) {
        return {0.0, range.contains(start) ? 1.0 : -1.0};
    }
    const auto [enter, leave] = std::minmax({(range.lower - start) / step, (range.upper - start) / step});
    return {enter, leave};
}

} // namespace

std::size_t nearestIndex(std::span<const double> time, double t)
{
    assert(!time.empty());
    const auto index = static_cast<std::size_t>(std::ranges::lower_bound(time, t) - time.begin());
    const bool isBefore = index == time.size() || (index > 0 && t - time[index - 1] < time[index] - t);
    return isBefore ? index - 1 : index;
}

std::vector<CurvePoint> decimate(std::span<const double> time, std::span<const double> values, const Interval &range,
                                 std::size_t columns)
{
    assert(time.size() == values.size() && columns > 0);
    const auto indexOf = [&](auto place) { return static_cast<std::size_t>(place - time.begin()); };
    std::size_t next = indexOf(std::ranges::lower_bound(time, range.lower));
    const std::size_t end = std::min(time.size(), indexOf(std::ranges::upper_bound(time, range.upper)) + 1);
    next -= next > 0 ? 1 : 0;
    const bool isFew = end - next <= 2 * columns;
    const auto columnOf = [&, scale = static_cast<double>(columns) / range.length()](std::size_t i) {
        return std::clamp(std::floor((time[i] - range.lower) * scale), 0.0, static_cast<double>(columns) - 1.0);
    };
    std::vector<CurvePoint> points;
    while (next < end) {
        std::array<std::size_t, 3> kept{next, next, end}; // lowest, highest, first gap
        const double column = columnOf(next);
        do {
            if (std::isfinite(values[next])) {
                kept[0] = values[next] >= values[kept[0]] ? kept[0] : next; // also from NaN
                kept[1] = values[next] <= values[kept[1]] ? kept[1] : next;
            } else {
                kept[2] = std::min(kept[2], next);
            }
            ++next;
        } while (!isFew && next < end && columnOf(next) == column);
        std::ranges::sort(kept);
        const auto last = std::unique(kept.begin(), kept.end());
        for (auto i = kept.begin(); i != last && *i < end; ++i) {
            points.push_back({time[*i], std::isfinite(values[*i]) ? values[*i] : kNoValue});
        }
    }
    return points;
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

std::optional<Interval> extremes(std::span<const CurvePoint> points)
{
    Interval range{kInfinity, -kInfinity};
    for (const CurvePoint &point : points) {
        range.lower = point.value < range.lower ? point.value : range.lower; // NaN is not smaller
        range.upper = point.value > range.upper ? point.value : range.upper;
    }
    return range.lower > range.upper ? std::nullopt : std::optional(range);
}

double quantile(std::span<const CurvePoint> points, double part)
{
    std::vector<double> values;
    for (const CurvePoint &point : points) {
        if (std::isfinite(point.value)) {
            values.push_back(point.value);
        }
    }
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, place);
    return *place;
}

std::vector<CurvePoint> clip(std::span<const CurvePoint> points, const Interval &time, const Interval &values)
{
    constexpr double kFar = 1e6; // axis lengths; farther away, rounding errors would exceed the length of the axis
    const Interval reachable{values.lower - kFar * values.length(), values.upper + kFar * values.length()};
    std::vector<CurvePoint> kept;
    kept.reserve(points.size());
    const CurvePoint *before = nullptr; // null after a gap
    const auto endLine = [&](double t) {
        if (!kept.empty() && !std::isnan(kept.back().value)) {
            kept.push_back({t, kNoValue});
        }
    };
    for (const CurvePoint &to : points) {
        if (std::isnan(to.value)) {
            endLine(to.t);
            before = nullptr;
            continue;
        }
        const CurvePoint &from = before ? *before : to;
        before = &to;
        const double fromValue = std::clamp(from.value, reachable.lower, reachable.upper);
        const double dt = to.t - from.t;
        const double dv = std::clamp(to.value, reachable.lower, reachable.upper) - fromValue;
        const Interval inTime = partWithin(from.t, dt, time);
        const Interval inValues = partWithin(fromValue, dv, values);
        const double enter = std::max({0.0, inTime.lower, inValues.lower});
        const double leave = std::min({1.0, inTime.upper, inValues.upper});
        if (enter > leave) {
            endLine(to.t);
            continue;
        }
        const auto at = [&](double along) {
            return CurvePoint{std::clamp(from.t + along * dt, time.lower, time.upper),
                              std::clamp(fromValue + along * dv, values.lower, values.upper)};
        };
        if (enter > 0.0) {
            endLine(at(enter).t);
        }
        if (kept.empty() || std::isnan(kept.back().value)) {
            kept.push_back(at(enter));
        }
        if (&from != &to) {
            kept.push_back(leave < 1.0 ? at(leave) : to);
        }
        if (leave < 1.0) {
            endLine(kept.back().t);
        }
    }
    return kept;
}

std::vector<CurvePoint> isolatedPoints(std::span<const CurvePoint> points)
{
    std::vector<CurvePoint> isolated;
    bool isAfterGap = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool isGap = std::isnan(points[i].value);
        if (!isGap && isAfterGap && (i + 1 == points.size() || std::isnan(points[i + 1].value))) {
            isolated.push_back(points[i]);
        }
        isAfterGap = isGap;
    }
    return isolated;
}

} // namespace slidercrank
