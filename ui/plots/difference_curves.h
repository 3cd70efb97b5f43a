// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far the model is from another exact motion, as curves of |model − other|, computed where the pixels are. Values
// are in the unit of the author's files; NaN: one of the two does not exist.

#include "core/closed_form/batch.h"
#include "core/mechanism/channel.h"
#include "ui/plots/curve_sampling.h"
#include "ui/text/interval.h"

#include <array>
#include <vector>

namespace slidercrank
{

class DifferenceCurves
{
public:
    using Curves = std::array<std::vector<CurvePoint>, kPlottedChannels.size()>;

    /// During that run (s).
    DifferenceCurves(const Mechanism &model, const Mechanism &other, const Interval &run);

    /// What plots of that range show with so many pixel columns; of many turns in one, a stroke from the least to the
    /// largest.
    Curves curves(const Interval &range, std::size_t columns) const;

    /// At that instant (s); the channel counts as in kPlottedChannels.
    double value(std::size_t channel, double t) const;

private:
    using Values = std::array<std::vector<double>, kPlottedChannels.size()>;
    Values valuesAt(const std::vector<double> &instants) const;

    ClosedFormBatch m_model;
    ClosedFormBatch m_other;
    double m_speed; ///< |ω2| of the faster one
    Interval m_run;
};

} // namespace slidercrank
