// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/motion_curves.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr double kBeyondAll = 1e300; // in place of ±∞: farther than any axis reaches, and lines to there can be cut

double brought(double value)
{
    return std::clamp(value, -kBeyondAll, kBeyondAll);
}

void addGap(std::vector<CurvePoint> &points, double t)
{
    if (!points.empty() && !std::isnan(points.back().value)) {
        points.push_back({t, kNoValue});
    }
}

void include(std::optional<Interval> &range, double value)
{
    range = range ? Interval{std::min(range->lower, value), std::max(range->upper, value)} : Interval{value, value};
}

/// Disjoint and ascending; what touches becomes one.
std::vector<Interval> merged(std::vector<Interval> intervals)
{
    std::ranges::sort(intervals, {}, &Interval::lower);
    std::vector<Interval> result;
    for (const Interval &interval : intervals) {
        constexpr double kTouching = 1e-9;
        if (!result.empty() && interval.lower <= result.back().upper + kTouching * std::abs(interval.lower)) {
            result.back().upper = std::max(result.back().upper, interval.upper);
        } else {
            result.push_back(interval);
        }
    }
    return result;
}

/// So many from one end to the other, both included.
std::vector<double> instantsAcross(const Interval &range, std::size_t pieces)
{
    std::vector<double> instants;
    instants.reserve(pieces + 1);
    for (std::size_t i = 0; i < pieces; ++i) {
        instants.push_back(range.lower + range.length() * static_cast<double>(i) / static_cast<double>(pieces));
    }
    instants.push_back(range.upper);
    return instants;
}

/// A stroke for each column and band, up and down in turn where there is only one.
std::vector<CurvePoint> strokes(const std::vector<Interval> &bands, const Interval &range, std::size_t columns)
{
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

MotionCurves::MotionCurves(const Mechanism &mechanism, const Interval &run)
    : m_motion(mechanism)
    , m_run(run)
    , m_speed(std::abs(mechanism.omega2()))
    , m_phase0(mechanism.omega2() < 0.0 ? -mechanism.theta20() : mechanism.theta20())
{
    if (m_speed > 0.0) {
        const bool isBackwards = mechanism.omega2() < 0.0;
        using Kind = CriticalPoint::Kind;
        std::array<CriticalPoints, kChannels> courses = findCriticalPoints(mechanism);
        for (std::size_t channel = 0; channel < kChannels; ++channel) {
            CriticalPoints &course = courses[channel];
            if (isBackwards) {
                std::ranges::reverse(course);
            }
            Passages &passages = m_passages[channel];
            for (const CriticalPoint &point : course) {
                const Kind kind = !isBackwards || point.kind == Kind::Extremum ? point.kind
                                  : point.kind == Kind::Begin                  ? Kind::End
                                                                               : Kind::Begin;
                passages.push_back({wrapToTwoPi(isBackwards ? -point.theta2 : point.theta2),
                                    brought(toFileUnit(kPlottedChannels[channel], point.value)), kind});
            }
            std::ranges::stable_sort(passages, {}, &Passage::phase);

            // From one beginning to the next end; all round where there is none.
            const auto begin = std::ranges::find(passages, Kind::Begin, &Passage::kind);
            const auto first = begin == passages.end() ? passages.begin() : begin;
            std::vector<Interval> &bands = m_bands[channel];
            for (std::size_t i = 0; i < passages.size(); ++i) {
                const auto offset = static_cast<std::size_t>(first - passages.begin());
                const Passage &passage = passages[(offset + i) % passages.size()];
                if (bands.empty() || passage.kind == Kind::Begin) {
                    bands.push_back({passage.value, passage.value});
                }
                bands.back() = {std::min(bands.back().lower, passage.value),
                                std::max(bands.back().upper, passage.value)};
            }
            bands = merged(std::move(bands));
        }
    }
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
        m_extremes[channel] = extremesOf(channel, m_run);
    }
}

MotionCurves::Samples MotionCurves::samplesAt(std::vector<double> instants) const
{
    Samples samples;
    samples.time = std::move(instants);
    for (std::vector<double> &values : samples.values) {
        values.resize(samples.time.size());
    }
    std::vector<Status> statuses(samples.time.size());
    m_motion.evaluate(samples.time,
                      {samples.values[0].data(), samples.values[1].data(), samples.values[2].data(),
                       samples.values[3].data(), samples.values[4].data(), samples.values[5].data()},
                      statuses);
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
        toFileUnit(kPlottedChannels[channel], samples.values[channel]);
    }
    return samples;
}

double MotionCurves::value(std::size_t channel, double t) const
{
    return samplesAt({t}).values[channel].front();
}

/// Those after the one instant and until the other, as visit(instant, passage).
template <class Visit>
void MotionCurves::visitPassages(std::size_t channel, double from, double to, const Visit &visit) const
{
    const Passages &passages = m_passages[channel];
    constexpr double kLargestAngle = 1e12; // rad: beyond, a double does not tell where in its turn the crank is
    const double phase = phaseAt(from);
    if (passages.empty() || !(std::abs(phase) <= kLargestAngle && std::abs(phaseAt(to)) <= kLargestAngle)) {
        return;
    }
    double turnsBegin = kTurn * std::floor(phase / kTurn);
    const auto after = std::ranges::upper_bound(passages, phase - turnsBegin, {}, &Passage::phase);
    for (auto next = after;; ++next) {
        if (next == passages.end()) {
            next = passages.begin();
            turnsBegin += kTurn;
        }
        const double t = from + (turnsBegin - phase + next->phase) / m_speed;
        if (!(t <= to)) {
            return;
        }
        visit(std::max(from, t), *next);
    }
}

std::optional<Interval> MotionCurves::extremes(std::size_t channel, const Interval &part) const
{
    const Interval within{std::max(part.lower, m_run.lower), std::min(part.upper, m_run.upper)};
    if (within == m_run) {
        return m_extremes[channel];
    }
    return within.lower <= within.upper ? extremesOf(channel, within) : std::nullopt;
}

std::optional<Interval> MotionCurves::extremesOf(std::size_t channel, const Interval &part) const
{
    const double turned = m_speed * part.length();
    const bool isWhole = turned >= kTurn;
    constexpr double kAndALittle = 1.001; // so that no rounding loses what is at its ends
    const double end = isWhole ? std::min(part.upper, part.lower + kAndALittle * kTurn / m_speed) : part.upper;
    std::optional<Interval> range;
    bool isUnbounded = false;
    visitPassages(channel, part.lower, end, [&](double, const Passage &passage) {
        if (std::abs(passage.value) < kBeyondAll) {
            include(range, passage.value);
        } else {
            isUnbounded = true;
        }
    });
    if (!isUnbounded) {
        for (const double t : {part.lower, part.upper}) {
            if (const double atEnd = value(channel, t); std::isfinite(atEnd)) {
                include(range, atEnd);
            }
        }
        return range;
    }
    constexpr std::size_t kLooks = 400;
    constexpr std::size_t kOneInSoMany = 20; // to either side
    std::vector<double> values = samplesAt(instantsAcross({part.lower, end}, kLooks)).values[channel];
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    std::ranges::sort(values);
    if (!values.empty()) {
        const std::size_t left = values.size() / kOneInSoMany;
        include(range, values[left]);
        include(range, values[values.size() - 1 - left]);
    }
    return range;
}

std::vector<CurvePoint> MotionCurves::line(std::size_t channel, const Samples &edges) const
{
    const std::vector<double> &values = edges.values[channel];
    std::vector<CurvePoint> points;
    points.reserve(values.size());
    std::size_t next = 0; // edge
    const auto addEdgesUntil = [&](double t) {
        for (; next < values.size() && edges.time[next] <= t; ++next) {
            if (std::isfinite(values[next])) {
                points.push_back({edges.time[next], values[next]});
            } else {
                addGap(points, edges.time[next]);
            }
        }
    };
    visitPassages(channel, edges.time.front(), edges.time.back(), [&](double t, const Passage &passage) {
        addEdgesUntil(t);
        if (passage.kind == CriticalPoint::Kind::Begin) {
            addGap(points, t);
        }
        points.push_back({t, passage.value});
        if (passage.kind == CriticalPoint::Kind::End) {
            addGap(points, t);
        }
    });
    addEdgesUntil(edges.time.back());
    return points;
}

MotionCurves::Curves MotionCurves::curves(const Interval &range, std::size_t columns) const
{
    Curves curves;
    const Interval shown{std::max(range.lower, m_run.lower), std::min(range.upper, m_run.upper)};
    if (!(shown.lower <= shown.upper)) {
        return curves;
    }
    const double part = range.length() > 0.0 ? shown.length() / range.length() : 1.0;
    const auto pixels = static_cast<std::size_t>(std::ceil(std::max(1.0, part * static_cast<double>(columns))));
    const bool holdWholeTurns = m_speed * shown.length() >= kTurn * static_cast<double>(pixels);
    if (holdWholeTurns && std::ranges::none_of(m_bands, &std::vector<Interval>::empty)) {
        for (std::size_t channel = 0; channel < kChannels; ++channel) {
            curves[channel] = strokes(m_bands[channel], shown, pixels);
        }
        return curves;
    }
    const Samples edges = samplesAt(instantsAcross(shown, shown.length() > 0.0 ? 2 * pixels : 0));
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
        curves[channel] = line(channel, edges);
    }
    return curves;
}

} // namespace slidercrank
