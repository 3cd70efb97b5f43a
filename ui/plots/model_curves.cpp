// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/model_curves.h"

#include "core/mechanism/in_parallel.h"
#include "ui/document/result.h"

#include <algorithm>
#include <iterator>

namespace slidercrank
{

namespace
{

/// Instants one after the other and what the motion is there; the memory is used again and again.
class Piece
{
public:
    /// From the first of these instants on, in ascending order.
    void compute(const ClosedFormBatch &motion, const Sampling &sampling, std::size_t first, std::size_t count)
    {
        m_time.resize(count);
        m_status.resize(count);
        const bool backwards = sampling.duration < 0.0;
        const int lowest = backwards ? sampling.steps - static_cast<int>(first + count - 1) : static_cast<int>(first);
        for (std::size_t i = 0; i < count; ++i) {
            m_time[i] = sampling.instant(lowest + static_cast<int>(i));
        }
        if (backwards) {
            std::reverse(m_time.begin(), m_time.end());
        }
        for (std::vector<double> &values : m_values) {
            values.resize(count);
        }
        motion.evaluate(m_time,
                        {m_values[0].data(), m_values[1].data(), m_values[2].data(), m_values[3].data(),
                         m_values[4].data(), m_values[5].data()},
                        m_status);
    }

    std::span<const double> time() const { return m_time; }
    std::span<const double> values(std::size_t channel) const { return m_values[channel]; }

private:
    std::vector<double> m_time;
    std::array<std::vector<double>, ModelCurves::kChannels> m_values; ///< as in PlottedColumns
    std::vector<Status> m_status;
};

/// All of a piece, or the two points that one pixel column of it shows.
PixelColumns wholeOf(std::size_t count, bool asOneColumn)
{
    PixelColumns columns{0, count, {}};
    if (asOneColumn) {
        columns.starts = {0, count};
    }
    return columns;
}

} // namespace

ModelCurves::ModelCurves(const Result &result)
    : m_size(result.summary.instants)
    , m_sampling(result.sampling)
{
    if (!result.isKept()) {
        m_motion.emplace(result.mechanism);
        return;
    }
    const Trajectory &trajectory = result.trajectory;
    m_time = trajectory.time;
    for (std::size_t i = 0; i < kChannels; ++i) {
        m_values[i] = trajectory[kPlottedChannels[i]];
    }
    if (m_size > 1 && m_time.back() < m_time.front()) {
        m_reversed.reserve((1 + kChannels) * m_size); // spans into it must stay valid
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

double ModelCurves::instant(std::size_t i) const
{
    return m_motion ? m_sampling.instant(static_cast<int>(m_sampling.duration < 0.0 ? m_size - 1 - i : i)) : m_time[i];
}

double ModelCurves::value(std::size_t channel, std::size_t i) const
{
    if (!m_motion) {
        return m_values[channel][i];
    }
    Piece piece;
    piece.compute(*m_motion, m_sampling, i, 1);
    return piece.values(channel).front();
}

std::size_t ModelCurves::nearest(double t) const
{
    return nearestIndex(
        m_size, [this](std::size_t i) { return instant(i); }, t);
}

std::vector<CurvePoint> ModelCurves::decimated(std::size_t channel, const Interval &range, std::size_t columns)
{
    return m_motion ? computed(range, columns)[channel]
                    : decimate(m_time, m_values[channel], pixelColumns(m_time, range, columns));
}

std::optional<Interval> ModelCurves::extremes(std::size_t channel)
{
    if (!m_motion) {
        return slidercrank::extremes(m_values[channel]);
    }
    constexpr std::size_t kAnyColumns = 256;
    const std::size_t columns = m_views.empty() ? kAnyColumns : m_views.front().columns;
    return m_size == 0 ? std::nullopt
                       : slidercrank::extremes(computed({instant(0), instant(m_size - 1)}, columns)[channel]);
}

const ModelCurves::Curves &ModelCurves::computed(const Interval &range, std::size_t columns)
{
    const auto known = std::find_if(m_views.begin(), m_views.end(),
                                    [&](const View &view) { return view.range == range && view.columns == columns; });
    if (known != m_views.end()) {
        return known->curves;
    }
    constexpr std::size_t kMostViews = 4;
    if (m_views.size() == kMostViews) {
        m_views.erase(m_views.begin());
    }
    m_views.push_back({range, columns, compute(range, columns)});
    return m_views.back().curves;
}

ModelCurves::Curves ModelCurves::compute(const Interval &range, std::size_t columns) const
{
    const PixelColumns pixels = pixelColumns(
        m_size, [this](std::size_t i) { return instant(i); }, range, columns);
    const bool all = pixels.starts.empty();
    const std::vector<std::size_t> starts = all ? std::vector{pixels.first, pixels.end} : pixels.starts;
    const std::size_t pieces = starts.size() - 1;

    // A few strips, each with memory of its own, small enough to stay near the processor.
    constexpr std::size_t kStrips = 8;
    std::array<Curves, kStrips> strips;
    inParallel(kStrips, [&](std::size_t strip) {
        Piece piece;
        for (std::size_t i = strip * pieces / kStrips; i < (strip + 1) * pieces / kStrips; ++i) {
            const std::size_t count = starts[i + 1] - starts[i];
            if (count == 0) {
                continue;
            }
            piece.compute(*m_motion, m_sampling, starts[i], count);
            const PixelColumns whole = wholeOf(count, !all);
            for (std::size_t channel = 0; channel < kChannels; ++channel) {
                std::ranges::copy(decimate(piece.time(), piece.values(channel), whole),
                                  std::back_inserter(strips[strip][channel]));
            }
        }
    });
    Curves curves;
    for (Curves &strip : strips) {
        for (std::size_t channel = 0; channel < kChannels; ++channel) {
            curves[channel].insert(curves[channel].end(), strip[channel].begin(), strip[channel].end());
        }
    }
    return curves;
}

} // namespace slidercrank
