// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Model and reference of the six plotted channels at common time stamps, and the error between them: the reference is a
// file, or the motion that was pinned last. Values are in the units of the reference files (mm, °, s).

#include "core/mechanism/channel.h"
#include "ui/document/result.h"
#include "ui/document/view_settings.h"
#include "ui/text/interval.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

struct ComparedChannel {
    std::span<const double> model;
    std::span<const double> reference; ///< empty: not in the file
    const ReferenceSeries *series = nullptr;
    double peak = 0.0;          ///< largest magnitude of the reference; ∞ where it grows beyond all bounds
    std::vector<double> errors; ///< as the axis shows them; not finite where undefined
    bool isUnbounded = false;   ///< no peak, or no largest error
};

class ComparedMotion
{
public:
    /// Compares with the file, at its time stamps. `result` must outlive the object.
    ComparedMotion(const Result &result, const PlotSettings &settings);

    /// Compares with the motion pinned last, at time stamps for a plot of that range with so many pixel columns.
    ComparedMotion(const Result &result, const PlotSettings &settings, const Interval &range, std::size_t columns);

    std::span<const double> time() const { return m_time; }
    const ComparedChannel &channel(std::size_t index) const { return m_channels[index]; } ///< as in kPlottedChannels

    /// The error in the chosen measure, a decimal logarithm where these are chosen; NaN where it is undefined.
    double error(std::size_t channel, double model, double reference) const;

    /// Whether a value of the reference is zero within its rounding, so that a percentage of it is undefined.
    bool isZero(std::size_t channel, double reference) const;

private:
    void computeErrors();

    PlotSettings m_settings;
    std::span<const double> m_time;
    std::vector<double> m_ownTime;
    std::array<std::vector<double>, kPlottedChannels.size()> m_ownModel;
    std::array<std::vector<double>, kPlottedChannels.size()> m_ownReference;
    std::array<ComparedChannel, kPlottedChannels.size()> m_channels;
};

} // namespace slidercrank
