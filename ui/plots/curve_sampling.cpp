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

/// The extremes of a run without gaps, or, where the sum is not finite, of a run that must be looked at one by one.
struct Run {
    double lower = kInfinity;
    double upper = -kInfinity;
    double sum = 0.0;
};

/// Four independent chains, because each comparison would otherwise wait for the one before.
Run scan(std::span<const double> values)
{
    constexpr std::size_t kChains = 4;
    std::array<Run, kChains> chains;
    const auto take = [](Run &run, double value) {
        run.lower = value < run.lower ? value : run.lower;
        run.upper = value > run.upper ? value : run.upper;
        run.sum += value;
    };
    std::size_t i = 0;
    for (; i + kChains <= values.size(); i += kChains) {
        for (std::size_t chain = 0; chain < kChains; ++chain) {
            take(chains[chain], values[i + chain]);
        }
    }
    for (; i < values.size(); ++i) {
        take(chains[0], values[i]);
    }
    Run all;
    for (const Run &run : chains) {
        all.lower = std::min(all.lower, run.lower);
        all.upper = std::max(all.upper, run.upper);
        all.sum += run.sum;
    }
    return all;
}

/// Two points for a run without gaps.
void appendRun(std::vector<CurvePoint> &points, std::span<const double> time, std::span<const double> values,
               double lower, double upper)
{
    const auto last = values.size() - 1;
    std::size_t lowest = 0;
    std::size_t highest = 0;
    // Nearly every run of a smooth curve rises or falls throughout; then nothing has to be searched.
    if (values[0] == lower && values[last] == upper) {
        highest = last;
    } else if (values[0] == upper && values[last] == lower) {
        lowest = last;
    } else {
        lowest = static_cast<std::size_t>(std::find(values.begin(), values.end(), lower) - values.begin());
        highest = static_cast<std::size_t>(std::find(values.begin(), values.end(), upper) - values.begin());
    }
    const auto [earlier, later] = std::minmax(lowest, highest);
    points.push_back({time[earlier], values[earlier]});
    if (later != earlier) {
        points.push_back({time[later], values[later]});
    }
}

/// The samples up to the first gap, the gap, what follows it: two points for each of the first and the rest.
/// A second gap within one pixel is not told from the first.
void appendBrokenRun(std::vector<CurvePoint> &points, std::span<const double> time, std::span<const double> values)
{
    const auto isGap = [](double value) { return !std::isfinite(value); };
    const auto firstGap = static_cast<std::size_t>(std::find_if(values.begin(), values.end(), isGap) - values.begin());
    if (firstGap > 0) {
        const Run run = scan(values.first(firstGap));
        appendRun(points, time, values.first(firstGap), run.lower, run.upper);
    }
    if (firstGap == values.size()) {
        return; // every value is finite, only their sum is not
    }
    points.push_back({time[firstGap], kNoValue});

    std::size_t lowest = values.size();
    std::size_t highest = values.size();
    for (std::size_t i = firstGap; i < values.size(); ++i) {
        if (isGap(values[i])) {
            continue;
        }
        lowest = lowest == values.size() || values[i] < values[lowest] ? i : lowest;
        highest = highest == values.size() || values[i] > values[highest] ? i : highest;
    }
    if (lowest == values.size()) {
        return;
    }
    const auto [earlier, later] = std::minmax(lowest, highest);
    points.push_back({time[earlier], values[earlier]});
    if (later != earlier) {
        points.push_back({time[later], values[later]});
    }
    if (isGap(values.back())) {
        points.push_back({time.back(), kNoValue});
    }
}

} // namespace

PixelColumns pixelColumns(std::span<const double> time, const Interval &range, std::size_t columns)
{
    assert(columns > 0);
    PixelColumns result;
    const auto firstInside = std::lower_bound(time.begin(), time.end(), range.lower);
    const auto endInside = std::upper_bound(firstInside, time.end(), range.upper);
    result.first = static_cast<std::size_t>(firstInside - time.begin());
    result.end = static_cast<std::size_t>(endInside - time.begin());
    if (result.first > 0) {
        --result.first;
    }
    if (result.end < time.size()) {
        ++result.end;
    }
    if (result.end - result.first <= 2 * columns) {
        return result;
    }
    result.starts.reserve(columns + 1);
    result.starts.push_back(result.first);
    auto from = firstInside;
    for (std::size_t column = 1; column < columns; ++column) {
        const double edge = range.lower + range.length() * static_cast<double>(column) / static_cast<double>(columns);
        from = std::lower_bound(from, endInside, edge);
        result.starts.push_back(static_cast<std::size_t>(from - time.begin()));
    }
    result.starts.push_back(result.end);
    return result;
}

std::size_t nearestIndex(std::span<const double> time, double t)
{
    assert(!time.empty());
    const auto index = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
    if (index == time.size() || (index > 0 && t - time[index - 1] < time[index] - t)) {
        return index - 1;
    }
    return index;
}

std::vector<CurvePoint> decimate(std::span<const double> time, std::span<const double> values,
                                 const PixelColumns &columns)
{
    assert(time.size() == values.size());
    std::vector<CurvePoint> points;
    if (columns.starts.empty()) {
        points.reserve(columns.end - columns.first);
        for (std::size_t i = columns.first; i < columns.end; ++i) {
            points.push_back({time[i], std::isfinite(values[i]) ? values[i] : kNoValue});
        }
        return points;
    }
    points.reserve(2 * columns.starts.size());
    for (std::size_t column = 0; column + 1 < columns.starts.size(); ++column) {
        const std::size_t begin = columns.starts[column];
        const std::size_t count = columns.starts[column + 1] - begin;
        if (count == 0) {
            continue;
        }
        const std::span<const double> columnTime = time.subspan(begin, count);
        const std::span<const double> columnValues = values.subspan(begin, count);
        const Run run = scan(columnValues);
        if (std::isfinite(run.sum)) {
            appendRun(points, columnTime, columnValues, run.lower, run.upper);
        } else {
            appendBrokenRun(points, columnTime, columnValues);
        }
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
    const CurvePoint *before = nullptr; // passed by the fan, not kept yet
    for (const CurvePoint &point : points) {
        if (std::isnan(point.value) || kept.empty() || std::isnan(kept.back().value)) {
            if (before) {
                kept.push_back(*before);
                before = nullptr;
            }
            kept.push_back(point);
            fan = {-kInfinity, kInfinity};
            continue;
        }
        double run = point.t - kept.back().t;
        double rise = point.value - kept.back().value;
        if (before && !(fan.lower * run <= rise && rise <= fan.upper * run)) {
            kept.push_back(*before);
            fan = {-kInfinity, kInfinity};
            run = point.t - kept.back().t;
            rise = point.value - kept.back().value;
        }
        fan.lower = std::max(fan.lower, (rise - tolerance) / run);
        fan.upper = std::min(fan.upper, (rise + tolerance) / run);
        before = &point;
    }
    if (before) {
        kept.push_back(*before);
    }
    return kept;
}

std::optional<Interval> extremes(std::span<const double> values)
{
    Run run = scan(values);
    if (!std::isfinite(run.sum)) {
        run = {};
        for (const double value : values) {
            if (std::isfinite(value)) {
                run.lower = std::min(run.lower, value);
                run.upper = std::max(run.upper, value);
            }
        }
    }
    return run.lower > run.upper ? std::nullopt : std::optional(Interval{run.lower, run.upper});
}

std::optional<Interval> extremes(std::span<const CurvePoint> points)
{
    Run run;
    for (const CurvePoint &point : points) {
        run.lower = point.value < run.lower ? point.value : run.lower;
        run.upper = point.value > run.upper ? point.value : run.upper;
    }
    return run.lower > run.upper ? std::nullopt : std::optional(Interval{run.lower, run.upper});
}

std::optional<Interval> extremesWithin(std::span<const double> time, std::span<const double> values,
                                       const Interval &range)
{
    if (values.empty()) {
        return std::nullopt;
    }
    const auto begin = std::lower_bound(time.begin(), time.end(), range.lower);
    const auto end = std::upper_bound(begin, time.end(), range.upper);
    const auto first = static_cast<std::size_t>(begin - time.begin());
    const auto behind = static_cast<std::size_t>(end - time.begin());
    std::optional<Interval> found = extremes(values.subspan(first, behind - first));
    const auto includeLine = [&](std::size_t to, double t) { // at its end of the range
        if (to == 0 || to == time.size()) {
            return;
        }
        const double part = (t - time[to - 1]) / (time[to] - time[to - 1]);
        const double value = values[to - 1] + part * (values[to] - values[to - 1]);
        if (std::isfinite(value)) {
            found =
                found ? Interval{std::min(found->lower, value), std::max(found->upper, value)} : Interval{value, value};
        }
    };
    includeLine(first, range.lower);
    includeLine(behind, range.upper);
    return found;
}

std::vector<CurvePoint> clip(std::span<const CurvePoint> points, const Interval &time, const Interval &values)
{
    const auto isInside = [&](const CurvePoint &point) {
        return time.contains(point.t) && values.contains(point.value);
    };
    std::vector<CurvePoint> kept;
    kept.reserve(points.size());
    const auto breakOff = [&kept](double t) {
        if (!kept.empty() && !std::isnan(kept.back().value)) {
            kept.push_back({t, kNoValue});
        }
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const CurvePoint &to = points[i];
        if (std::isnan(to.value)) {
            breakOff(to.t);
            continue;
        }
        if (i == 0 || std::isnan(points[i - 1].value)) {
            if (isInside(to)) {
                kept.push_back(to);
            }
            continue;
        }
        const CurvePoint &from = points[i - 1];
        if (isInside(from) && isInside(to)) {
            kept.push_back(to);
            continue;
        }
        // Liang and Barsky: the part [enter, leave] of the segment that lies within all four edges.
        double enter = 0.0;
        double leave = 1.0;
        const auto cut = [&enter, &leave](double start, double step, const Interval &range) {
            if (step == 0.0) {
                return range.contains(start);
            }
            const double a = (range.lower - start) / step;
            const double b = (range.upper - start) / step;
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
            return enter <= leave;
        };
        // From farther away than that no digit of the axes would be left.
        constexpr double kFar = 1e6;
        const auto brought = [&values](double value) {
            return std::clamp(value, values.lower - kFar * values.length(), values.upper + kFar * values.length());
        };
        const double fromValue = brought(from.value);
        const double dt = to.t - from.t;
        const double dv = brought(to.value) - fromValue;
        if (!cut(from.t, dt, time) || !cut(fromValue, dv, values)) {
            breakOff(from.t);
            continue;
        }
        const auto at = [&](double part) {
            return CurvePoint{std::clamp(from.t + part * dt, time.lower, time.upper),
                              std::clamp(fromValue + part * dv, values.lower, values.upper)};
        };
        if (enter > 0.0) {
            const CurvePoint entry = at(enter);
            breakOff(entry.t);
            kept.push_back(entry);
        }
        kept.push_back(leave < 1.0 ? at(leave) : to);
        if (leave < 1.0) {
            breakOff(kept.back().t);
        }
    }
    return kept;
}

std::vector<CurvePoint> cutIntoDashes(std::span<const CurvePoint> points, const DashPattern &pattern)
{
    std::vector<CurvePoint> cut;
    cut.reserve(2 * points.size());
    bool isDash = true;
    double left = pattern.dash; // of the dash or gap under way
    for (std::size_t i = 0; i < points.size(); ++i) {
        const CurvePoint &to = points[i];
        const bool begins = i == 0 || std::isnan(points[i - 1].value);
        if (std::isnan(to.value)) {
            cut.push_back(to);
            continue;
        }
        if (begins) {
            isDash = true;
            left = pattern.dash;
            cut.push_back(to);
            continue;
        }
        const CurvePoint &from = points[i - 1];
        const double dx = (to.t - from.t) * pattern.perT;
        const double dy = (to.value - from.value) * pattern.perValue;
        const double length = std::sqrt(dx * dx + dy * dy);
        double done = 0.0;
        while (length - done > left) {
            done += left;
            const double part = done / length;
            const CurvePoint at{from.t + part * (to.t - from.t), from.value + part * (to.value - from.value)};
            cut.push_back(at);
            if (isDash) {
                cut.push_back({at.t, kNoValue});
            }
            isDash = !isDash;
            left = isDash ? pattern.dash : pattern.gap;
        }
        left -= length - done;
        if (isDash) {
            cut.push_back(to);
        }
    }
    return cut;
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
