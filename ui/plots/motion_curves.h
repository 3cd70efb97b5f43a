// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the six plotted channels of a motion as curves over ascending time. In closed form a curve does not depend
// on the sampling of the motion: it is computed twice per pixel, and at every extremum and every limit of the motion.
// If the crank makes a whole turn within a pixel, the curve is a band between the extremes. With Newton-Raphson a curve
// consists of the samples that were solved. Channels are numbered as in kPlottedChannels; values are in the units of
// files (mm, °, s).

#include "core/limits/critical_points.h"
#include "core/sampling/trajectory.h"
#include "ui/plots/curve_sampling.h"

#include <array>
#include <optional>
#include <vector>

namespace slidercrank
{

class MotionCurves
{
public:
    /// Curves of the exact motion within a time range (s).
    MotionCurves(const Mechanism &mechanism, const Interval &time)
        : m_mechanism(mechanism)
        , m_time(time)
    {
    }

    /// Curves of samples, which must outlive the object.
    explicit MotionCurves(const Trajectory &samples)
        : m_samples(&samples)
    {
    }

    bool isExact() const { return !m_samples; }

    /// Returns whether the motion is exact and the mechanism cannot be assembled at some crank angles.
    bool canHaveGaps() const;

    /// Returns the time (s) nearest to t at which the curves have values.
    double nearestTime(double t) const;

    /// Returns the value at a time that nearestTime() returned, or NaN if there is none.
    double value(std::size_t channel, double time) const;

    struct Curve {
        std::vector<CurvePoint> points;
        std::optional<Interval> values; ///< usualRange() of its values within the time shown
        bool isDense = false;           ///< whether the curve looks like a band, in which dashes cannot be seen
    };
    using Curves = std::array<Curve, kPlottedChannels.size()>;

    /// Returns the curves for a plot of that time range that is `columns` pixels wide.
    Curves curves(const Interval &range, std::size_t columns) const;

private:
    std::vector<CurvePoint> exactPoints(std::size_t channel, const Trajectory &samples,
                                        const CriticalPoints &criticalPoints) const;

    const Trajectory *m_samples = nullptr; ///< null if the motion is exact
    Mechanism m_mechanism;
    Interval m_time;
};

} // namespace slidercrank
