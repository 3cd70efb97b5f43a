// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/motion_errors.h"

#include "core/mechanism/turn.h"
#include "ui/text/notation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

/// Returns at least two time stamps per pixel, and more if the crank turns fast. They are not evenly spaced, because a
/// few evenly spaced time stamps could lie at the same crank angle in every turn.
std::vector<double> timeStamps(const Interval &range, double turns, std::size_t columns)
{
    constexpr double kStampsPerTurn = 32.0;
    constexpr double kMaxStampsPerPixel = 32.0;
    const auto pixels = static_cast<double>(columns);
    const double pieces = std::ceil(std::clamp(kStampsPerTurn * turns, 2.0 * pixels, kMaxStampsPerPixel * pixels));
    std::vector<double> stamps;
    for (double i = 0.0; i < pieces; ++i) {
        stamps.push_back(range.lower + range.length() * (i + std::fmod(i * std::numbers::phi, 1.0)) / pieces);
    }
    stamps.push_back(range.upper);
    return stamps;
}

} // namespace

MotionErrors::MotionErrors(const Result &result, const PlotSettings &settings, const Interval &range,
                           std::size_t columns)
    : m_settings(settings)
{
    const Reference *file = result.reference.get();
    Trajectory sampled;
    if (!file) {
        const Mechanism pinned(result.pinned.back());
        const double speed = std::max(std::abs(result.mechanism.omega2()), std::abs(pinned.omega2()));
        m_pinned = sample(pinned, timeStamps(range, speed * range.length() / kTurn, columns), plottedChannels(), {});
        sampled = sample(result.mechanism, m_pinned.time, plottedChannels(), {});
    }
    const Trajectory &model = file ? result.atReference : sampled;
    m_time = file ? file->data.time : m_pinned.time;
    const std::vector<ChannelComparison> &comparisons = file ? result.comparison : result.difference->channels;
    for (std::size_t channel = 0; channel < m_errors.size(); ++channel) {
        const Channel plotted = kPlottedChannels[channel];
        const auto comparison = std::ranges::find(comparisons, plotted, &ChannelComparison::channel);
        if (comparison == comparisons.end()) {
            continue;
        }
        Errors &errors = m_errors[channel];
        errors.series = file ? file->data.find(plotted) : nullptr;
        errors.factor = shownScale(plotted, result.mechanism.branch()).factor;
        errors.peak = comparison->peak;
        errors.isUnbounded = !std::isfinite(errors.peak) || !std::isfinite(comparison->largestError.value_or(0.0));
        errors.reference = file ? errors.series->values : m_pinned[plotted];
        for (std::size_t i = 0; i < errors.reference.size(); ++i) {
            const double value = error(channel, model[plotted][i], errors.reference[i]);
            errors.values.push_back(value);
            if (settings.error == ErrorMeasure::Percent && std::isnan(value) && std::isfinite(model[plotted][i]) &&
                std::isfinite(errors.reference[i])) {
                errors.undefined.push_back(m_time[i]);
            }
        }
    }
}

double MotionErrors::error(std::size_t channel, double model, double reference) const
{
    constexpr double kPercent = 100.0;
    const Errors &errors = m_errors[channel];
    double error = std::abs(model - reference);
    if (m_settings.error == ErrorMeasure::Absolute) {
        error *= errors.factor;
    } else if (m_settings.error == ErrorMeasure::Percent) {
        constexpr double kZeroFraction = 1e-12; // fraction of the peak; smaller numbers are rounding errors of zero
        const double halfStep = errors.series ? 0.5 * errors.series->rounding.stepAt(reference) : 0.0;
        const double largestZero = std::max(std::isfinite(errors.peak) ? kZeroFraction * errors.peak : 0.0, halfStep);
        error = std::abs(reference) <= largestZero ? kNone : kPercent * error / std::abs(reference);
    } else if (!std::isfinite(errors.peak)) {
        error = kNone;
    } else if (error != 0.0) { // an error of 0 is 0 % even if the peak is 0
        error = kPercent * error / errors.peak;
    }
    return m_settings.logarithmicError ? std::log10(error) : error;
}

} // namespace slidercrank
