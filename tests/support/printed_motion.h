// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Prints the motion of a slider-crank as a simulation program would: the textbook's formulas in long double, rounded by
// printf. The closed form, which they judge, shares no formula with them.

#include "core/closed_form/textbook_motion.h"
#include "core/mechanism/mechanism.h"
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

/// In the order of kPlottedChannels, in the default units (mm, °, s).
inline constexpr std::size_t kPrintedChannels = kPlottedChannels.size();
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

struct Printing {
    double from = 0.0; ///< s
    double to = 1.0;
    int rows = 201;
    std::string channels = "111111"; ///< 1: printed, in the order of kPlottedChannels
    const char *format = "%.6g";
    const char *timeFormat = "%.9g";
};

/// Returns the CSV text. The cells for which `isGap(row, channel)` is true are empty.
template <typename IsGap>
std::string printedMotion(const Parameters &parameters, const Printing &printing, IsGap isGap)
{
    std::string text = "time";
    for (std::size_t k = 0; k < kPrintedChannels; ++k) {
        if (printing.channels[k] == '1') {
            text += ',' + std::string(nameOf(kPlottedChannels[k]));
        }
    }
    std::array<char, 64> cell{};
    const auto print = [&](const char *format, double value) {
        std::snprintf(cell.data(), cell.size(), format, value);
        return cell.data();
    };
    for (int row = 0; row < printing.rows; ++row) {
        text += '\n';
        const double part = static_cast<double>(row) / (printing.rows - 1);
        text += print(printing.timeFormat, printing.from + (printing.to - printing.from) * part);
        const PrintedRow motion = textbookMotion(parameters, std::strtod(cell.data(), nullptr));
        for (std::size_t k = 0; k < kPrintedChannels; ++k) {
            if (printing.channels[k] == '1') {
                text += ',';
                if (std::isfinite(motion[k]) && !isGap(row, k)) {
                    text += print(printing.format, static_cast<double>(motion[k]));
                }
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
    return printedData(parameters, printing, [](int, std::size_t) { return false; });
}

/// Returns the column of a channel that the data contain.
inline std::vector<double> &valuesOf(ReferenceData &data, Channel channel)
{
    return std::ranges::find(data.series, channel, &ReferenceSeries::channel)->values;
}

} // namespace slidercrank
