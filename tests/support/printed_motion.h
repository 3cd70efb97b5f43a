// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Prints the motion of a slider-crank as a simulation program would: the textbook's formulas in long double, rounded by
// printf. It shares no code with the core that it judges.

#include "core/import/reference_data.h"
#include "core/mechanism/mechanism.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <variant>

namespace slidercrank
{

/// In the order of kPlottedChannels, in the default units (mm, °, s).
inline constexpr std::size_t kPrintedChannels = 6;
using PrintedRow = std::array<long double, kPrintedChannels>;

/// Computes the motion at time t (Norton, "Design of Machinery", eq. 4.16, 6.22, 7.15). Returns NaN where the mechanism
/// cannot be assembled.
inline PrintedRow textbookMotion(const Parameters &p, long double t)
{
    const long double pi = std::acos(-1.0L);
    const long double degree = pi / 180.0L;
    const long double a = p.a;
    const long double b = p.b;
    const long double w = p.omega2;
    const long double theta2 = w * t + static_cast<long double>(p.theta20);
    const long double sine = (p.c - a * std::sin(theta2)) / b;
    const long double steepness = std::asin(sine);
    const long double theta3 = p.branch == Branch::Open ? steepness : pi - steepness;
    const long double bCos = b * std::cos(theta3);
    const long double bSin = b * std::sin(theta3);
    const long double w3 = -a * w * std::cos(theta2) / bCos;
    const long double alpha3 = (a * w * w * std::sin(theta2) + bSin * w3 * w3) / bCos;
    return {theta3 / degree, a * std::cos(theta2) + bCos,
            w3 / degree,     -a * w * std::sin(theta2) - bSin * w3,
            alpha3 / degree, -a * w * w * std::cos(theta2) - bCos * w3 * w3 - bSin * alpha3};
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
    static constexpr std::array<const char *, kPrintedChannels> kHeadings{"theta3",    "R4_x",         "theta3_diff",
                                                                          "R4_x_diff", "theta3_diff2", "R4_x_diff2"};
    std::string text = "time";
    for (std::size_t k = 0; k < kPrintedChannels; ++k) {
        if (printing.channels[k] == '1') {
            text += std::string(",") + kHeadings[k];
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

} // namespace slidercrank
