// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/curve_sampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void appendGap(std::vector<CurvePoint> &points, double t)
{
    if (points.empty() || !std::isnan(points.back().value)) {
        points.push_back({t, kNoValue});
    }
}

/// Appends the extremes of the samples of one pixel column. The first gap splits them; a second one within the same
/// pixel is not told from the first.
void appendColumn(std::vector<CurvePoint> &points, std::span<const double> time, std::span<const double> values)
{
    const std::size_t none = time.size();
    std::size_t lowest = none;
    std::size_t highest = none;
    bool hasGap = false;
    const auto appendExtremes = [&] {
        if (lowest != none) {
            const auto [earlier, later] = std::minmax(lowest, highest);
            points.push_back({time[earlier], values[earlier]});
            if (later != earlier) {
                points.push_back({time[later], values[later]});
            }
        }
        lowest = highest = none;
    };
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (std::isfinite(values[i])) {
            lowest = lowest == none || values[i] < values[lowest] ? i : lowest;
            highest = highest == none || values[i] > values[highest] ? i : highest;
        } else if (!hasGap) {
            appendExtremes();
            appendGap(points, time[i]);
            hasGap = true;
        }
    }
    appendExtremes();
    if (hasGap && !std::isfinite(values.back())) {
        appendGap(points, time.back());
    }
}

/// The part of a line that lies within an interval, as parts of its length.
struct Part {
    double enter = 0.0;
    double leave = 1.0;

    /// Liang and Barsky, A new concept and method for line clipping, 1984: one pair of parallel edges.
    void cut(double start, double step, const Interval &range)
    {
        if (step == 0.0) {
            leave = range.contains(start) ? leave : -1.0;
            return;
        }
        const double a = (range.lower - start) / step;
        const double b = (range.upper - start) / step;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
};

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
    const auto indexOf = [&time](auto place) { return static_cast<std::size_t>(place - time.begin()); };
    std::size_t first = indexOf(std::ranges::lower_bound(time, range.lower));
    std::size_t end = indexOf(std::ranges::upper_bound(time, range.upper));
    first -= first > 0 ? 1 : 0;
    end += end < time.size() ? 1 : 0;
    std::vector<CurvePoint> points;
    if (end - first <= 2 * columns) {
        points.reserve(end - first);
        for (std::size_t i = first; i < end; ++i) {
            points.push_back({time[i], std::isfinite(values[i]) ? values[i] : kNoValue});
        }
        return points;
    }
    points.reserve(2 * columns);
    std::size_t from = first;
    for (std::size_t column = 1; column <= columns; ++column) {
        const double edge = range.lower + range.length() * static_cast<double>(column) / static_cast<double>(columns);
        const std::size_t to = column == columns
                                   ? end
                                   : indexOf(std::lower_bound(time.begin() + static_cast<std::ptrdiff_t>(from),
                                                              time.begin() + static_cast<std::ptrdiff_t>(end), edge));
        if (to > from) {
            appendColumn(points, time.subspan(from, to - from), values.subspan(from, to - from));
        }
        from = to;
    }
    return points;
}

// From the last point kept, the slopes of all lines that pass every point since within the tolerance form a fan, which
// each further point narrows. The first point outside of the fan ends it: the one before is kept, and a new fan opens
// there.
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
        const double slope = (point.value - kept.back().value) / (point.t - kept.back().t);
        if (before && !fan.contains(slope)) {
            keepBefore();
        }
        const double run = point.t - kept.back().t;
        const double rise = point.value - kept.back().value;
        fan.lower = std::max(fan.lower, (rise - tolerance) / run);
        fan.upper = std::min(fan.upper, (rise + tolerance) / run);
        before = &point;
    }
    keepBefore();
    return kept;
}

std::optional<Interval> extremes(std::span<const CurvePoint> points)
{
    Interval range{kInfinity, -kInfinity};
    for (const CurvePoint &point : points) {
        range.lower = point.value < range.lower ? point.value : range.lower;
        range.upper = point.value > range.upper ? point.value : range.upper;
    }
    return range.lower > range.upper ? std::nullopt : std::optional(range);
}

std::vector<CurvePoint> clip(std::span<const CurvePoint> points, const Interval &time, const Interval &values)
{
    // From farther away than that no digit of the axes would be left.
    constexpr double kFar = 1e6;
    const Interval reachable{values.lower - kFar * values.length(), values.upper + kFar * values.length()};
    std::vector<CurvePoint> kept;
    kept.reserve(points.size());
    const auto isDrawing = [&kept] { return !kept.empty() && !std::isnan(kept.back().value); };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const CurvePoint &to = points[i];
        const CurvePoint &from = i > 0 && !std::isnan(points[i - 1].value) ? points[i - 1] : to;
        const double fromValue = std::clamp(from.value, reachable.lower, reachable.upper);
        const double dt = to.t - from.t;
        const double dv = std::clamp(to.value, reachable.lower, reachable.upper) - fromValue;
        Part part;
        part.cut(from.t, dt, time);
        part.cut(fromValue, dv, values);
        const bool isVisible = !std::isnan(to.value) && part.enter <= part.leave;
        const auto at = [&](double along) {
            return CurvePoint{std::clamp(from.t + along * dt, time.lower, time.upper),
                              std::clamp(fromValue + along * dv, values.lower, values.upper)};
        };
        if (isVisible && (part.enter > 0.0 || !isDrawing())) {
            if (isDrawing()) {
                kept.push_back({at(part.enter).t, kNoValue});
            }
            kept.push_back(at(part.enter));
        }
        if (isVisible && &from != &to) {
            kept.push_back(part.leave < 1.0 ? at(part.leave) : to);
        }
        if ((!isVisible || part.leave < 1.0) && isDrawing()) {
            kept.push_back({isVisible ? kept.back().t : to.t, kNoValue});
        }
    }
    return kept;
}

std::vector<CurvePoint> isolatedPoints(std::span<const CurvePoint> points)
{
    const auto isGap = [&points](std::size_t i) { return i >= points.size() || std::isnan(points[i].value); };
    std::vector<CurvePoint> isolated;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isGap(i) && (i == 0 || isGap(i - 1)) && isGap(i + 1)) {
            isolated.push_back(points[i]);
        }
    }
    return isolated;
}

} // namespace slidercrank
