// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/compared_motion.h"

#include "core/closed_form/closed_form.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slidercrank
{

namespace
{

/// Two time stamps a pixel, more where the cranks turn fast. Where even that is less than a few a turn they are not
/// evenly spaced, so that they do not meet every turn at the same place.
std::vector<double> timeStamps(const Interval &range, double turns, std::size_t columns)
{
    constexpr double kPerTurn = 32.0;
    constexpr double kMostPerPixel = 32.0;
    const auto pixels = static_cast<double>(columns);
    const double pieces = std::ceil(std::clamp(kPerTurn * turns, 2.0 * pixels, kMostPerPixel * pixels));
    const bool isSparse = kPerTurn * turns > pieces;
    std::vector<double> stamps;
    stamps.reserve(static_cast<std::size_t>(pieces) + 1);
    for (double i = 0.0; i < pieces; ++i) {
        const double shift = i * std::numbers::phi;
        stamps.push_back(range.lower + range.length() * (i + (isSparse ? shift - std::floor(shift) : 0.0)) / pieces);
    }
    stamps.push_back(range.upper);
    return stamps;
}

std::array<std::vector<double>, kPlottedChannels.size()> motionAt(const Mechanism &mechanism,
                                                                  const std::vector<double> &time)
{
    std::array<std::vector<double>, kPlottedChannels.size()> values;
    for (std::vector<double> &channel : values) {
        channel.resize(time.size());
    }
    std::vector<Status> statuses(time.size());
    ClosedForm(mechanism).evaluate(
        time,
        {values[0].data(), values[1].data(), values[2].data(), values[3].data(), values[4].data(), values[5].data()},
        statuses);
    for (std::size_t channel = 0; channel < values.size(); ++channel) {
        toFileUnit(kPlottedChannels[channel], values[channel]);
    }
    return values;
}

} // namespace

ComparedMotion::ComparedMotion(const Result &result, const PlotSettings &settings)
    : m_settings(settings)
    , m_time(result.reference->data.time)
{
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        ComparedChannel &channel = m_channels[i];
        channel.series = result.reference->data.find(kPlottedChannels[i]);
        if (!channel.series) {
            continue;
        }
        channel.model = result.atReference[kPlottedChannels[i]];
        channel.reference = channel.series->values;
        for (const double value : channel.reference) {
            channel.peak = std::abs(value) > channel.peak ? std::abs(value) : channel.peak; // NaN is not larger
        }
    }
    computeErrors();
}

ComparedMotion::ComparedMotion(const Result &result, const PlotSettings &settings, const Interval &range,
                               std::size_t columns)
    : m_settings(settings)
{
    const Mechanism pinned(result.kept.back());
    const double speed = std::max(std::abs(result.mechanism.omega2()), std::abs(pinned.omega2()));
    m_ownTime = timeStamps(range, speed * range.length() / kTurn, columns);
    m_ownModel = motionAt(result.mechanism, m_ownTime);
    m_ownReference = motionAt(pinned, m_ownTime);
    m_time = m_ownTime;
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        const ChannelDifference &difference = result.difference->channels[i];
        m_channels[i].model = m_ownModel[i];
        m_channels[i].reference = m_ownReference[i];
        m_channels[i].peak = difference.peak;
        m_channels[i].isUnbounded = !std::isfinite(difference.peak) || !std::isfinite(difference.maxAbs.value_or(0.0));
    }
    computeErrors();
}

void ComparedMotion::computeErrors()
{
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        ComparedChannel &channel = m_channels[i];
        channel.errors.resize(channel.reference.size());
        for (std::size_t k = 0; k < channel.errors.size(); ++k) {
            channel.errors[k] = error(i, channel.model[k], channel.reference[k]);
        }
    }
}

bool ComparedMotion::isZero(std::size_t index, double reference) const
{
    constexpr double kPartOfPeak = 1e-12; // what rounding leaves of a zero beside values of the size of the peak
    const ComparedChannel &channel = m_channels[index];
    const double halfStep = channel.series ? 0.5 * channel.series->rounding.stepAt(reference) : 0.0;
    return std::abs(reference) <= std::max(std::isfinite(channel.peak) ? kPartOfPeak * channel.peak : 0.0, halfStep);
}

double ComparedMotion::error(std::size_t index, double model, double reference) const
{
    constexpr double kPercent = 100.0;
    double error = std::abs(model - reference);
    switch (m_settings.error) {
    case ErrorMeasure::Percent:
        error = isZero(index, reference) ? std::numeric_limits<double>::quiet_NaN()
                                         : kPercent * error / std::abs(reference);
        break;
    case ErrorMeasure::Absolute: break;
    case ErrorMeasure::OfPeak:
        // 0 of a peak of 0 is no error; anything else of it has no percentage.
        error = error == 0.0 ? 0.0 : kPercent * error / m_channels[index].peak;
        error = std::isfinite(m_channels[index].peak) ? error : std::numeric_limits<double>::quiet_NaN();
        break;
    }
    return m_settings.logarithmicError ? std::log10(error) : error;
}

} // namespace slidercrank
