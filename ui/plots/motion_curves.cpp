// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/motion_curves.h"

#include "core/closed_form/closed_form.h"
#include "core/limits/mobility.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Returns the curve of a crank so fast that it makes a whole turn within each pixel column: in each column a vertical
/// line from the smallest to the largest value of `turn`, the motion during one turn. If gaps divide `turn`, each part
/// has a line of its own.
std::vector<CurvePoint> bandOf(const std::vector<CurvePoint> &turn, const Interval &range, std::size_t columns)
{
    std::vector<Interval> bands;
    bool isInPart = false;
    for (const CurvePoint &point : turn) {
        if (!isInPart && !std::isnan(point.value)) {
            bands.push_back({point.value, point.value});
        }
        isInPart = !std::isnan(point.value);
        if (isInPart) {
            bands.back().include(point.value);
        }
    }
    std::vector<CurvePoint> points;
    points.reserve(3 * bands.size() * columns);
    for (std::size_t i = 0; i < columns; ++i) {
        const double t = range.lower + range.length() * (static_cast<double>(i) + 0.5) / static_cast<double>(columns);
        for (const Interval &band : bands) {
            points.insert(points.end(), {{t, band.lower}, {t, band.upper}, {t, kNone}});
        }
    }
    return points;
}

} // namespace

bool MotionCurves::canHaveGaps() const
{
    return isExact() && motionLimits(m_mechanism).mobility != Mobility::FullTurn;
}

double MotionCurves::nearestTime(double t) const
{
    return isExact() ? std::clamp(t, m_time.lower, m_time.upper) : m_samples->time[nearestIndex(m_samples->time, t)];
}

double MotionCurves::value(std::size_t channel, double time) const
{
    const Channel plotted = kPlottedChannels[channel];
    if (!isExact()) {
        return (*m_samples)[plotted][nearestIndex(m_samples->time, time)];
    }
    const double theta2 = m_mechanism.theta20() + m_mechanism.omega2() * time;
    if (plotted.order != Order::Position && m_mechanism.omega2() != 0.0 && velocitiesJumpAt(m_mechanism, theta2)) {
        return kNone;
    }
    double value = kNone;
    Status status = Status::Solved;
    PlottedColumns columns{};
    columns[channel] = &value;
    ClosedForm(m_mechanism).evaluate({&time, 1}, columns, {&status, 1}); // faster than sample() for a single time
    return toFileUnit(plotted, value);
}

/// Returns the samples and the critical points between them, with a gap beyond each limit of the motion.
std::vector<CurvePoint> MotionCurves::exactPoints(std::size_t channel, const Trajectory &samples,
                                                  const CriticalPoints &criticalPoints) const
{
    std::vector<CurvePoint> points;
    for (std::size_t i = 0; i < samples.time.size(); ++i) {
        const double value = samples[kPlottedChannels[channel]][i];
        points.push_back({samples.time[i], std::isfinite(value) ? value : kNone});
    }
    const Interval range{samples.time.front(), samples.time.back()};
    const double omega2 = m_mechanism.omega2();
    const double period = kTurn / std::abs(omega2);
    const double turns = std::ceil(range.length() / period);
    for (const CriticalPoint &point : criticalPoints) {
        const double timeInFirstTurn = (point.theta2 - m_mechanism.theta20()) / omega2;
        const double turnsBeforeRange = std::ceil((range.lower - timeInFirstTurn) / period);
        const double value = std::clamp(toFileUnit(kPlottedChannels[channel], point.value), -kBeyondAll, kBeyondAll);
        // If the crank turns backwards, begin and end are exchanged.
        const bool endsCurve = (point.kind == CriticalPoint::Kind::End) == (omega2 > 0.0);
        for (double turn = 0.0; turn <= turns; ++turn) {
            const double t = timeInFirstTurn + (turnsBeforeRange + turn) * period;
            if (range.contains(t)) {
                points.push_back({t, value});
                if (point.kind != CriticalPoint::Kind::Extremum) {
                    const double timeOfGap = std::nextafter(t, endsCurve ? kInfinity : -kInfinity);
                    points.push_back({.t = timeOfGap, .value = kNone});
                }
            }
        }
    }
    std::ranges::stable_sort(points, {}, &CurvePoint::t);
    return points;
}

MotionCurves::Curves MotionCurves::curves(const Interval &range, std::size_t columns) const
{
    constexpr int kSamplesPerTurn = 400;
    constexpr double kSampledTurn = 1.001 * kTurn; // more than a turn, so that rounding errors lose no critical point
    Curves curves;
    if (!isExact()) {
        for (std::size_t channel = 0; channel < curves.size(); ++channel) {
            std::vector<CurvePoint> points =
                decimate(m_samples->time, (*m_samples)[kPlottedChannels[channel]], range, columns);
            // With 1.5 points or more per pixel column, the curve looks like a band.
            const bool isDense = 2 * points.size() >= 3 * columns;
            curves[channel] = {.points = points, .values = usualRange(points, range), .isDense = isDense};
        }
        return curves;
    }
    const Interval shown{std::max(range.lower, m_time.lower), std::min(range.upper, m_time.upper)};
    if (shown.isEmpty()) {
        return curves;
    }
    const double speed = std::abs(m_mechanism.omega2());
    const bool isBand = speed * shown.length() >= kTurn * static_cast<double>(columns);
    const Sampling sampling{.start = shown.lower,
                            .duration = isBand ? kSampledTurn / speed : shown.length(),
                            .steps = isBand ? kSamplesPerTurn : 2 * static_cast<int>(columns)};
    const Trajectory samples = sample(m_mechanism, sampling.timeStamps(), plottedChannels(), {});
    const auto critical = findCriticalPoints(m_mechanism);
    for (std::size_t channel = 0; channel < curves.size(); ++channel) {
        const std::vector<CurvePoint> points = exactPoints(channel, samples, critical[channel]);
        curves[channel] = {.points = isBand ? bandOf(points, shown, columns) : points,
                           .values = usualRange(points, {samples.time.front(), samples.time.back()}),
                           .isDense = isBand};
    }
    return curves;
}

} // namespace slidercrank
