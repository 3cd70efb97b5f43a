// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Prints the motion of a slider-crank as a simulation program would: the textbook's formulas in long double, rounded by
// printf. The closed form, which they judge, shares no formula with them.

#include "core/closed_form/textbook_motion.h"
#include "core/mechanism/mechanism.h"
#include "tests/support/channels.h"
#include "tests/support/reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace slidercrank
{

/// Returns a channel at a crank angle (rad), in the unit of files (mm, °, s). Returns NaN where the mechanism cannot be
/// assembled.
inline long double textbookValue(const Parameters &p, Channel channel, long double theta2)
{
    constexpr auto kPi = std::numbers::pi_v<long double>;
    TextbookMotion<long double> motion;
    return motion.compute({p.a, p.b, p.c, p.omega2}, theta2, p.branch == Branch::Open ? 1.0 : -1.0, kPi)
               ? motion.valueAt(channel) * (isAngle(channel.coordinate) ? 180.0L / kPi : 1.0L)
               : std::numeric_limits<long double>::quiet_NaN();
}

inline constexpr std::size_t kPrintedChannels = kPlottedChannels.size();
/// Values in the order of kPlottedChannels, in the units of files (mm, °, s).
using PrintedRow = std::array<long double, kPrintedChannels>;

/// Returns the plotted channels at time t.
inline PrintedRow textbookMotion(const Parameters &p, long double t)
{
    PrintedRow row{};
    for (std::size_t k = 0; k < kPrintedChannels; ++k) {
        row[k] = textbookValue(p, kPlottedChannels[k], p.omega2 * t + p.theta20);
    }
    return row;
}

// Columns that are often printed together.
inline const std::vector<Channel> kSixChannels(kPlottedChannels.begin(), kPlottedChannels.end());
inline const std::vector<Channel> kCouplerChannels{kTheta3, kTheta3Speed, kTheta3Acceleration};
inline const std::vector<Channel> kSliderChannels{kSlider, kSliderSpeed, kSliderAcceleration};
inline const std::vector<Channel> kAngleAndPosition{kTheta3, kSlider};

/// Returns the names of channels, for messages: "theta3 R4_x".
inline std::string namesOf(const std::vector<Channel> &channels)
{
    std::string names;
    for (const Channel channel : channels) {
        names += names.empty() ? "" : " ";
        names += nameOf(channel);
    }
    return names;
}

struct Printing {
    double from = 0.0; ///< first time stamp, s
    double to = 1.0;   ///< last time stamp, s
    int rows = 201;
    std::vector<Channel> channels = kSixChannels; ///< of the columns after the time
    const char *format = "%.6g";
    const char *timeFormat = "%.9g";
};

/// Returns the CSV text. The cells for which `isGap(row, channel)` is true are empty.
template <typename IsGap>
std::string printedMotion(const Parameters &parameters, const Printing &printing, IsGap isGap)
{
    std::string text = "time";
    for (const Channel channel : printing.channels) {
        text += ',' + std::string(nameOf(channel));
    }
    std::array<char, 64> cell{};
    const auto print = [&](const char *format, double value) {
        std::snprintf(cell.data(), cell.size(), format, value);
        return cell.data();
    };
    for (int row = 0; row < printing.rows; ++row) {
        text += '\n';
        const double fraction = static_cast<double>(row) / (printing.rows - 1);
        text += print(printing.timeFormat, printing.from + (printing.to - printing.from) * fraction);
        const long double theta2 =
            parameters.omega2 * static_cast<long double>(std::strtod(cell.data(), nullptr)) + parameters.theta20;
        for (const Channel channel : printing.channels) {
            text += ',';
            const long double value = textbookValue(parameters, channel, theta2);
            if (std::isfinite(value) && !isGap(row, channel)) {
                text += print(printing.format, static_cast<double>(value));
            }
        }
    }
    text += '\n';
    return text;
}

/// Prints the motion and reads it with the program's reader. Returns empty data if it cannot be read.
template <typename IsGap>
ReferenceData printedData(const Parameters &parameters, const Printing &printing, IsGap isGap)
{
    auto outcome = readReferenceData(printedMotion(parameters, printing, isGap));
    ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    return data ? std::move(*data) : ReferenceData();
}

inline ReferenceData printedData(const Parameters &parameters, const Printing &printing = {})
{
    return printedData(parameters, printing, [](int, Channel) { return false; });
}

/// Returns the column of a channel that the data contain.
inline std::vector<double> &valuesOf(ReferenceData &data, Channel channel)
{
    return std::ranges::find(data.series, channel, &ReferenceSeries::channel)->values;
}

} // namespace slidercrank
