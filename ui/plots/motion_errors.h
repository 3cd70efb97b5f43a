// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the errors of the model in each of the plotted channels. The reference values are those of the file, at its
// time stamps, or without a file those of the motion that was pinned last. Values are in the units of files (mm, °, s),
// absolute errors in the units that are shown.

#include "ui/document/result.h"
#include "ui/document/view_settings.h"
#include "ui/plots/motion_curves.h"

#include <array>
#include <span>
#include <vector>

namespace slidercrank
{

class MotionErrors
{
public:
    /// Requires result.isCompared(); `result` must outlive the object. Without a file, the motions are compared at time
    /// stamps for a plot of the time `range` (s) that is `columns` pixels wide.
    MotionErrors(const Result &result, const PlotSettings &settings, const Interval &range, std::size_t columns);

    struct Errors {
        const ReferenceSeries *series = nullptr; ///< the column of the file; null without one
        double factor = 1.0;                     ///< converts an absolute error to the unit shown
        double peak = 0.0;                       ///< largest magnitude of the reference; may be infinite
        bool isUnbounded = false;                ///< whether the errors have no finite maximum
        std::span<const double> reference;       ///< values; empty if the channel is not in the file
        std::vector<double> values;              ///< in the chosen measure; not finite where undefined
        std::vector<double> undefined;           ///< time stamps (s) at which a percentage would divide by zero
    };
    std::span<const double> time() const { return m_time; }
    /// Channels are numbered as in kPlottedChannels.
    const Errors &operator[](std::size_t channel) const { return m_errors[channel]; }

    /// Returns the error in the chosen measure, or its decimal logarithm if that is chosen; NaN if it is undefined.
    double error(std::size_t channel, double model, double reference) const;

private:
    PlotSettings m_settings;
    std::span<const double> m_time;
    std::array<Errors, kPlottedChannels.size()> m_errors;
    Trajectory m_pinned; ///< the pinned motion at m_time; empty if there is a file
};

} // namespace slidercrank
