// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The six plotted channels of the exact motion as curves, true to the pixel: computed where the pixels are, with every
// place at which the motion turns, begins or ends in between, and where a pixel holds a whole turn of the crank, as a
// band between the extremes. No count of samples is in them. Values are in the unit of the author's files.

#include "core/closed_form/closed_form.h"
#include "core/limits/critical_points.h"
#include "ui/plots/curve_sampling.h"
#include "ui/text/interval.h"

#include <array>
#include <optional>
#include <vector>

namespace slidercrank
{

class MotionCurves
{
public:
    static constexpr std::size_t kChannels = kPlottedChannels.size();
    using Curves = std::array<std::vector<CurvePoint>, kChannels>;

    /// Of that run (s).
    MotionCurves(const Mechanism &mechanism, const Interval &run);

    const Interval &run() const { return m_run; }

    /// What a plot of that range shows with so many pixel columns: every curve within half a pixel of the motion, and
    /// the motion within half a pixel of its curve.
    Curves curves(const Interval &range, std::size_t columns) const;

    /// At that instant (s); NaN where it does not exist.
    double value(std::size_t channel, double t) const;

    /// Of the run: its peaks, sampled or not. Where it grows beyond all bounds, as beside a rocker's limits, what it
    /// does not exceed nine tenths of the time.
    const std::optional<Interval> &extremes(std::size_t channel) const { return m_extremes[channel]; }

    /// Of that part of it.
    std::optional<Interval> extremes(std::size_t channel, const Interval &part) const;

private:
    /// A place of the course as the crank comes by in the course of time.
    struct Passage {
        double phase = 0.0; ///< rad, within [0, 2π), growing with time
        double value = 0.0;
        CriticalPoint::Kind kind = CriticalPoint::Kind::Extremum;
    };
    using Passages = std::vector<Passage>;

    /// Instants and what the motion is there.
    struct Samples {
        std::vector<double> time;
        std::array<std::vector<double>, kChannels> values;
    };

    Samples samplesAt(std::vector<double> instants) const;
    double phaseAt(double t) const { return m_phase0 + m_speed * t; }
    std::optional<Interval> extremesOf(std::size_t channel, const Interval &part) const;
    std::vector<CurvePoint> line(std::size_t channel, const Samples &edges) const;

    template <class Visit>
    void visitPassages(std::size_t channel, double from, double to, const Visit &visit) const;

    ClosedForm m_motion;
    Interval m_run;
    double m_speed;  ///< |ω2|
    double m_phase0; ///< at t = 0
    std::array<Passages, kChannels> m_passages;
    std::array<std::vector<Interval>, kChannels> m_bands; ///< all values of a whole turn; disjoint, ascending
    std::array<std::optional<Interval>, kChannels> m_extremes;
};

} // namespace slidercrank
