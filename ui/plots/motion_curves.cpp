// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/motion_curves.h"

#include "core/mechanism/turn.h"
#include "core/sampling/trajectory.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kBeyondAll = 1e300; // replaces ±∞: beyond the end of any axis, but lines to it can be clipped
using Kind = CriticalPoint::Kind;

void addGap(std::vector<CurvePoint> &points, double t)
{
    if (!points.empty() && !std::isnan(points.back().value)) {
        points.push_back({t, kNoValue});
    }
}

/// Returns the time stamps that divide the range into equal pieces, including both ends.
std::vector<double> evenTime(const Interval &range, std::size_t pieces)
{
    std::vector<double> time;
    time.reserve(pieces + 1);
    for (std::size_t i = 0; i < pieces; ++i) {
        time.push_back(range.lower + range.length() * static_cast<double>(i) / static_cast<double>(pieces));
    }
    time.push_back(range.upper);
    return time;
}

std::optional<Interval> usualExtremes(std::vector<CurvePoint> points)
{
    const auto isBeyondAll = [](const CurvePoint &point) { return std::abs(point.value) >= kBeyondAll; };
    const bool isUnbounded = std::erase_if(points, isBeyondAll) > 0;
    const std::optional<Interval> range = extremes(points);
    constexpr double kLeftOut = 0.05; // of the values, at either end
    return isUnbounded && range ? Interval{quantile(points, kLeftOut), quantile(points, 1.0 - kLeftOut)} : range;
}

/// Returns a vertical line in each pixel column for each part of a turn without gaps. If there is only one part, the
/// lines go up and down alternately and are connected.
std::vector<CurvePoint> strokes(const std::vector<CurvePoint> &turn, const Interval &range, std::size_t columns)
{
    std::vector<Interval> bands;
    bool isOpen = false;
    for (const CurvePoint &point : turn) {
        if (!std::isnan(point.value)) {
            const Interval known = isOpen ? bands.back() : Interval{point.value, point.value};
            bands.resize(bands.size() + (isOpen ? 0 : 1));
            bands.back() = {std::min(known.lower, point.value), std::max(known.upper, point.value)};
        }
        isOpen = !std::isnan(point.value);
    }
    std::vector<CurvePoint> points;
    points.reserve(3 * bands.size() * columns);
    for (std::size_t i = 0; i < columns; ++i) {
        const double t = range.lower + range.length() * (static_cast<double>(i) + 0.5) / static_cast<double>(columns);
        for (const Interval &band : bands) {
            const bool falls = bands.size() == 1 && i % 2 == 1;
            points.push_back({t, falls ? band.upper : band.lower});
            points.push_back({t, falls ? band.lower : band.upper});
            if (bands.size() > 1) {
                points.push_back({t, kNoValue});
            }
        }
    }
    return points;
}

} // namespace

MotionSamples sampleMotion(const ClosedForm &motion, std::vector<double> time)
{
    MotionSamples samples{std::move(time), {}};
    PlottedColumns columns{};
    for (std::size_t channel = 0; channel < columns.size(); ++channel) {
        samples.values[channel].resize(samples.time.size());
        columns[channel] = samples.values[channel].data();
    }
    std::vector<Status> statuses(samples.time.size());
    motion.evaluate(samples.time, columns, statuses);
    for (std::size_t channel = 0; channel < columns.size(); ++channel) {
        toFileUnit(kPlottedChannels[channel], samples.values[channel]);
    }
    return samples;
}

MotionCurves::MotionCurves(const Mechanism &mechanism, const Interval &time)
    : m_motion(mechanism)
    , m_time(time)
    , m_speed(std::abs(mechanism.omega2()))
    , m_phase0(mechanism.omega2() < 0.0 ? -mechanism.theta20() : mechanism.theta20())
{
    if (m_speed > 0.0) {
        const std::array points = findCriticalPoints(mechanism);
        for (std::size_t channel = 0; channel < points.size(); ++channel) {
            addPassages(channel, points[channel], mechanism.omega2() < 0.0);
        }
    }
}

MotionCurves::MotionCurves(const Trajectory &trajectory)
{
    m_samples.time = trajectory.time;
    const bool isBackwards = m_samples.time.size() > 1 && m_samples.time.back() < m_samples.time.front();
    if (isBackwards) {
        std::ranges::reverse(m_samples.time);
    }
    for (std::size_t channel = 0; channel < m_samples.values.size(); ++channel) {
        m_samples.values[channel] = trajectory[kPlottedChannels[channel]];
        if (isBackwards) {
            std::ranges::reverse(m_samples.values[channel]);
        }
    }
}

void MotionCurves::addPassages(std::size_t channel, const CriticalPoints &points, bool isBackwards)
{
    std::vector<Passage> &passages = m_passages[channel];
    for (const CriticalPoint &point : points) {
        const Kind reversed = point.kind == Kind::Begin ? Kind::End : Kind::Begin;
        const Kind kind = isBackwards && point.kind != Kind::Extremum ? reversed : point.kind;
        passages.push_back({wrapToTwoPi(isBackwards ? -point.theta2 : point.theta2),
                            std::clamp(toFileUnit(kPlottedChannels[channel], point.value), -kBeyondAll, kBeyondAll),
                            kind});
    }
    if (isBackwards) {
        std::ranges::reverse(passages); // at an exact toggle a channel ends and begins at the same angle
    }
    std::ranges::stable_sort(passages, {}, &Passage::phase);
}

double MotionCurves::nearestTime(double t) const
{
    if (isExact()) {
        return std::clamp(t, m_time.lower, m_time.upper);
    }
    return m_samples.time.empty() ? t : m_samples.time[nearestIndex(m_samples.time, t)];
}

double MotionCurves::value(std::size_t channel, double time) const
{
    if (isExact()) {
        return sampleMotion(*m_motion, {time}).values[channel].front();
    }
    return m_samples.time.empty() ? kNoValue : m_samples.values[channel][nearestIndex(m_samples.time, time)];
}

/// Returns the line through the samples and the critical points between them.
std::vector<CurvePoint> MotionCurves::line(std::size_t channel, const MotionSamples &samples) const
{
    const std::vector<double> &time = samples.time;
    const std::vector<double> &values = samples.values[channel];
    const std::vector<Passage> &passages = m_passages[channel];
    std::vector<CurvePoint> points;
    points.reserve(values.size() + passages.size());
    std::size_t next = 0;
    const auto addSamplesUntil = [&](double t) {
        for (; next < values.size() && time[next] <= t; ++next) {
            if (std::isfinite(values[next])) {
                points.push_back({time[next], values[next]});
            } else {
                addGap(points, time[next]);
            }
        }
    };
    constexpr double kLargestAngle = 1e12; // rad; beyond it a double cannot represent the position within a turn
    const double phase = m_phase0 + m_speed * time.front();
    if (!passages.empty() && std::max(std::abs(phase), std::abs(m_phase0 + m_speed * time.back())) <= kLargestAngle) {
        double turnStart = kTurn * std::floor(phase / kTurn);
        auto passage = std::ranges::upper_bound(passages, phase - turnStart, {}, &Passage::phase);
        for (;; ++passage) {
            if (passage == passages.end()) {
                passage = passages.begin();
                turnStart += kTurn;
            }
            const double t = std::max(time.front(), time.front() + (turnStart - phase + passage->phase) / m_speed);
            if (!(t <= time.back())) {
                break;
            }
            addSamplesUntil(t);
            if (passage->kind == Kind::Begin) {
                addGap(points, t);
            }
            points.push_back({t, passage->value});
            if (passage->kind == Kind::End) {
                addGap(points, t);
            }
        }
    }
    addSamplesUntil(time.back());
    return points;
}

MotionCurves::Curve MotionCurves::sampledCurve(std::size_t channel, const Interval &range, std::size_t columns) const
{
    constexpr Interval kAnyValue{-kBeyondAll, kBeyondAll};
    const std::vector<CurvePoint> points = decimate(m_samples.time, m_samples.values[channel], range, columns);
    return {points, extremes(clip(points, range, kAnyValue))};
}

void MotionCurves::computeExactCurves(const Interval &range, std::size_t columns)
{
    const Interval shown{std::max(range.lower, m_time.lower), std::min(range.upper, m_time.upper)};
    m_curves = {};
    if (!(shown.lower <= shown.upper)) {
        return;
    }
    const double part = range.length() > 0.0 ? shown.length() / range.length() : 1.0;
    const auto pixels = static_cast<std::size_t>(std::ceil(std::max(1.0, part * static_cast<double>(columns))));
    const bool isBand = m_speed * shown.length() >= kTurn * static_cast<double>(pixels);
    constexpr std::size_t kPerTurn = 400;
    constexpr double kWholeTurn = 1.001 * kTurn; // more than a turn, so that rounding errors lose no critical point
    const Interval sampled = isBand ? Interval{shown.lower, shown.lower + kWholeTurn / m_speed} : shown;
    const std::size_t pieces = isBand ? kPerTurn : shown.length() > 0.0 ? 2 * pixels : 0;
    const MotionSamples samples = sampleMotion(*m_motion, evenTime(sampled, pieces));
    for (std::size_t channel = 0; channel < m_curves.size(); ++channel) {
        std::vector<CurvePoint> points = line(channel, samples);
        m_curves[channel].extremes = usualExtremes(points);
        m_curves[channel].points = isBand ? strokes(points, shown, pixels) : std::move(points);
    }
}

const MotionCurves::Curves &MotionCurves::curves(const Interval &range, std::size_t columns)
{
    if (m_range != range || m_columns != columns) {
        m_range = range;
        m_columns = columns;
        if (isExact()) {
            computeExactCurves(range, columns);
        } else {
            for (std::size_t channel = 0; channel < m_curves.size(); ++channel) {
                m_curves[channel] = sampledCurve(channel, range, columns);
            }
        }
    }
    return m_curves;
}

} // namespace slidercrank
