// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The six plotted channels of a motion as curves over ascending time. In closed form they are the motion itself,
// whatever the sampling is; by Newton-Raphson the samples that it found, and nothing between them. Values are in the
// units of the reference files (mm, °, s); NaN: does not exist.

#include "core/sampling/trajectory.h"
#include "ui/plots/curve_sampling.h"
#include "ui/plots/motion_curves.h"

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace slidercrank
{

struct Result;

class ModelCurves
{
public:
    static constexpr std::size_t kChannels = kPlottedChannels.size();

    ModelCurves() = default; ///< nothing
    /// `result` must outlive it.
    explicit ModelCurves(const Result &result);
    /// The exact motion during that time (s).
    ModelCurves(const Mechanism &mechanism, const Interval &run)
        : m_motion(std::in_place, mechanism, run)
    {
    }

    ModelCurves(ModelCurves &&) = default; // a copy would refer to the memory of the original
    ModelCurves &operator=(ModelCurves &&) = default;

    bool empty() const { return !m_motion && m_time.empty(); }

    /// Whether the curves are the exact motion, not samples.
    bool isMotion() const { return m_motion.has_value(); }

    /// The time (s) nearest to t at which there are values. Requires that it is not empty.
    double instantNear(double t) const;

    /// The value at a time that instantNear() returned; channels count as in kPlottedChannels.
    double value(std::size_t channel, double instant) const;

    /// What a plot of that range shows with so many pixel columns.
    std::vector<CurvePoint> points(std::size_t channel, const Interval &range, std::size_t columns);

    /// The extremes within that range.
    std::optional<Interval> extremes(std::size_t channel, const Interval &range) const;

private:
    // Of samples.
    std::span<const double> m_time;
    std::array<std::span<const double>, kChannels> m_values;
    std::vector<double> m_reversed; ///< time and channels in ascending order, where the time runs backwards

    // Of the exact motion.
    struct View {
        Interval range;
        std::size_t columns = 0;
        MotionCurves::Curves curves;
    };
    std::optional<MotionCurves> m_motion;
    std::vector<View> m_views; ///< the last ones: plots may differ in width by a pixel
};

} // namespace slidercrank
