// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The model's six plotted channels as curves over ascending time. A run whose values were kept is looked up; a long one
// in closed form, which takes less time to compute than to store, is computed wherever somebody looks.

#include "core/closed_form/batch.h"
#include "core/mechanism/channel.h"
#include "core/run/trajectory.h"
#include "ui/plots/curve_sampling.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

struct Result;

class ModelCurves
{
public:
    static constexpr std::size_t kChannels = kPlottedChannels.size();

    ModelCurves() = default; ///< no instant
    /// `result` must outlive it.
    explicit ModelCurves(const Result &result);

    ModelCurves(ModelCurves &&) = default; // a copy would look into the memory of the other
    ModelCurves &operator=(ModelCurves &&) = default;

    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }

    /// The i-th sampled instant, s.
    double instant(std::size_t i) const;
    /// At the i-th instant; the channel counts as in kPlottedChannels. In the unit of the author's files; NaN where it
    /// does not exist.
    double value(std::size_t channel, std::size_t i) const;
    /// Which instant is nearest to t (s); there must be one.
    std::size_t nearest(double t) const;

    /// As slidercrank::decimate().
    std::vector<CurvePoint> decimated(std::size_t channel, const Interval &range, std::size_t columns);
    /// Of the whole run.
    std::optional<Interval> extremes(std::size_t channel);

private:
    using Curves = std::array<std::vector<CurvePoint>, kChannels>;

    /// What was computed for one view.
    struct View {
        Interval range;
        std::size_t columns = 0;
        Curves curves;
    };

    const Curves &computed(const Interval &range, std::size_t columns);
    Curves compute(const Interval &range, std::size_t columns) const;

    std::size_t m_size = 0;

    // Of a run that was kept.
    std::span<const double> m_time;
    std::array<std::span<const double>, kChannels> m_values;
    std::vector<double> m_reversed; ///< time and channels in ascending order, where the run goes backwards in time

    // Of a run that was not.
    std::optional<ClosedFormBatch> m_motion;
    Sampling m_sampling;
    std::vector<View> m_views; ///< of this result: columns of plots can differ by a pixel
};

} // namespace slidercrank
