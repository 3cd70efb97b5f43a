// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/model_curves.h"

#include "ui/document/result.h"

#include <algorithm>

namespace slidercrank
{

ModelCurves::ModelCurves(const Result &result)
{
    if (result.solver.method == Method::ClosedForm) {
        const Sampling &run = result.sampling;
        const double end = run.start + run.duration;
        m_motion.emplace(result.mechanism, Interval{std::min(run.start, end), std::max(run.start, end)});
        return;
    }
    const Trajectory &trajectory = result.trajectory;
    m_time = trajectory.time;
    for (std::size_t i = 0; i < kChannels; ++i) {
        m_values[i] = trajectory[kPlottedChannels[i]];
    }
    if (m_time.size() > 1 && m_time.back() < m_time.front()) {
        m_reversed.reserve((1 + kChannels) * m_time.size()); // spans into it must stay valid
        const auto reversed = [this](std::span<const double> values) {
            const auto begin = m_reversed.insert(m_reversed.end(), values.rbegin(), values.rend());
            return std::span<const double>(begin, m_reversed.end());
        };
        m_time = reversed(m_time);
        for (std::span<const double> &values : m_values) {
            values = reversed(values);
        }
    }
}

double ModelCurves::instantNear(double t) const
{
    return m_motion ? std::clamp(t, m_motion->run().lower, m_motion->run().upper) : m_time[nearestIndex(m_time, t)];
}

double ModelCurves::value(std::size_t channel, double instant) const
{
    return m_motion ? m_motion->value(channel, instant) : m_values[channel][nearestIndex(m_time, instant)];
}

std::vector<CurvePoint> ModelCurves::points(std::size_t channel, const Interval &range, std::size_t columns)
{
    if (!m_motion) {
        return decimate(m_time, m_values[channel], range, columns);
    }
    const auto known =
        std::ranges::find_if(m_views, [&](const View &view) { return view.range == range && view.columns == columns; });
    if (known != m_views.end()) {
        return known->curves[channel];
    }
    constexpr std::size_t kMostViews = 4;
    if (m_views.size() == kMostViews) {
        m_views.erase(m_views.begin());
    }
    m_views.push_back({range, columns, m_motion->curves(range, columns)});
    return m_views.back().curves[channel];
}

std::optional<Interval> ModelCurves::extremes(std::size_t channel, const Interval &range) const
{
    if (m_motion) {
        return m_motion->extremes(channel, range);
    }
    constexpr std::size_t kColumns = 4096; // enough for every screen
    constexpr double kAnything = 1e300;
    const std::vector<CurvePoint> points = decimate(m_time, m_values[channel], range, kColumns);
    return slidercrank::extremes(clip(points, range, {-kAnything, kAnything}));
}

} // namespace slidercrank
