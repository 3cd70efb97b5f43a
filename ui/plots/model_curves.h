// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The model's six plotted channels as curves over ascending time. In closed form they are the motion itself, whatever
// the run's steps are; by Newton-Raphson the samples that it found, and nothing between them. Values are in the unit of
// the author's files; NaN: does not exist.

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
    /// The motion itself, during that run (s).
    ModelCurves(const Mechanism &mechanism, const Interval &run)
        : m_motion(std::in_place, mechanism, run)
    {
    }

    ModelCurves(ModelCurves &&) = default; // a copy would look into the memory of the other
    ModelCurves &operator=(ModelCurves &&) = default;

    bool empty() const { return !m_motion && m_time.empty(); }

    /// Else samples.
    bool isMotion() const { return m_motion.has_value(); }

    /// What can be read next to t (s): there, within the run, or at the nearest sample. Not of an empty one.
    double instantNear(double t) const;

    /// At one of these instants; the channel counts as in kPlottedChannels.
    double value(std::size_t channel, double instant) const;

    /// What a plot of that range shows with so many pixel columns.
    std::vector<CurvePoint> points(std::size_t channel, const Interval &range, std::size_t columns);
    /// Of what is to be seen in that range.
    std::optional<Interval> extremes(std::size_t channel, const Interval &range) const;

private:
    // Of samples.
    std::span<const double> m_time;
    std::array<std::span<const double>, kChannels> m_values;
    std::vector<double> m_reversed; ///< time and channels in ascending order, where the run goes backwards in time

    // Of the motion.
    struct View {
        Interval range;
        std::size_t columns = 0;
        MotionCurves::Curves curves;
    };
    std::optional<MotionCurves> m_motion;
    std::vector<View> m_views; ///< columns of plots can differ by a pixel
};

} // namespace slidercrank
