// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The six plotted channels of a motion as curves over ascending time. In closed form they are the motion itself, true
// to the pixel whatever the sampling is: computed at the pixels, with every extremum and every limit of the motion in
// between, and as a band between the extremes where a pixel holds a whole turn of the crank. By Newton-Raphson they are
// the samples that it found. Channels count as in kPlottedChannels; values are in the units of files (mm, °, s).

#include "core/closed_form/closed_form.h"
#include "core/limits/critical_points.h"
#include "ui/plots/curve_sampling.h"

#include <array>
#include <optional>
#include <vector>

namespace slidercrank
{

struct Trajectory;

struct MotionSamples {
    std::vector<double> time; ///< s
    std::array<std::vector<double>, kPlottedChannels.size()> values;
};

/// NaN where the motion does not exist.
MotionSamples sampleMotion(const ClosedForm &motion, std::vector<double> time);

class MotionCurves
{
public:
    /// The exact motion during that time (s).
    MotionCurves(const Mechanism &mechanism, const Interval &time);

    /// Samples in the order of time or in the reverse order.
    explicit MotionCurves(const Trajectory &trajectory);

    bool isExact() const { return m_motion.has_value(); }

    /// The time (s) nearest to t at which the curves have values.
    double nearestTime(double t) const;

    /// The value at a time that nearestTime() returned; NaN where it does not exist.
    double value(std::size_t channel, double time) const;

    struct Curve {
        std::vector<CurvePoint> points;

        /// Of the values within the range on show. Where they grow beyond all bounds, as beside the limits of an
        /// oscillating crank, nine tenths of them.
        std::optional<Interval> extremes;
    };
    using Curves = std::array<Curve, kPlottedChannels.size()>;

    /// What a plot of that range shows with so many pixel columns. Valid until the next call.
    const Curves &curves(const Interval &range, std::size_t columns);

private:
    /// A critical point as the crank passes it in the course of time.
    struct Passage {
        double phase = 0.0; ///< rad, within [0, 2π), growing with time
        double value = 0.0;
        CriticalPoint::Kind kind = CriticalPoint::Kind::Extremum;
    };

    void addPassages(std::size_t channel, const CriticalPoints &points, bool isBackwards);
    Curve sampledCurve(std::size_t channel, const Interval &range, std::size_t columns) const;
    void computeExactCurves(const Interval &range, std::size_t columns);
    std::vector<CurvePoint> line(std::size_t channel, const MotionSamples &samples) const;

    std::optional<ClosedForm> m_motion;
    Interval m_time;
    double m_speed = 0.0;  ///< |ω2|
    double m_phase0 = 0.0; ///< rad, at t = 0
    std::array<std::vector<Passage>, kPlottedChannels.size()> m_passages;
    MotionSamples m_samples; ///< unless it is exact

    Curves m_curves; ///< of the last call
    std::optional<Interval> m_range;
    std::size_t m_columns = 0;
};

} // namespace slidercrank
