// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/axis_scale.h"

#include "ui/text/written_number.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

double largestMagnitude(const Interval &range)
{
    return std::max(std::abs(range.lower), std::abs(range.upper));
}

} // namespace

QString AxisScale::label(double value, const QLocale &locale) const
{
    if (isLogarithmic) {
        return powerOfTen(static_cast<int>(std::lround(value)));
    }
    // A tick near zero is shown as 0, not as -0 or as the rounding error of the steps, such as 1e-17.
    const double shown = std::abs(value) < step * 1e-6 ? 0.0 : value / std::pow(10.0, exponent);
    return locale.toString(shown, 'f', decimals);
}

QString AxisScale::unit(const QString &unit) const
{
    return exponent == 0 ? unit : QStringLiteral("%1 %2").arg(powerOfTen(exponent), unit);
}

int AxisScale::labelLength(const Interval &range) const
{
    const auto length = [this](double value) { return static_cast<int>(label(value, QLocale::c()).size()); };
    return std::max(length(range.lower), length(range.upper));
}

AxisScale axisScale(const Interval &range, double intervals)
{
    AxisScale scale;
    scale.step = nextRoundNumber(range.length() / std::max(intervals, 1.0));
    constexpr double kSmallestPlain = 1e-4;
    constexpr double kLargestPlain = 1e5;
    const double largest = largestMagnitude(range);
    if (largest > 0.0 && std::isfinite(largest) && (largest < kSmallestPlain || largest >= kLargestPlain)) {
        scale.exponent = 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
    }
    constexpr double kRoundingRoom = 1e-9;
    constexpr double kMostDecimals = 17.0;
    const double exponentOfStep = std::log10(scale.step) - scale.exponent; // not finite if the range underflows
    const double decimals = -std::floor(exponentOfStep + kRoundingRoom);
    scale.decimals = decimals > 0.0 ? static_cast<int>(std::min(decimals, kMostDecimals)) : 0;
    return scale;
}

AxisScale degreeScale(const Interval &range, double intervals)
{
    constexpr std::array<double, 6> kPartsOfATurn{10.0, 15.0, 30.0, 45.0, 90.0, 180.0};
    constexpr double kTurn = 360.0;
    const double wanted = range.length() / std::max(intervals, 1.0);
    AxisScale scale = axisScale(range, intervals);
    if (wanted <= 0.5 * kPartsOfATurn.front() || scale.exponent != 0) {
        return scale;
    }
    const auto part = std::lower_bound(kPartsOfATurn.begin(), kPartsOfATurn.end(), wanted);
    scale.step = part != kPartsOfATurn.end() ? *part : kTurn * std::max(1.0, nextRoundNumber(wanted / kTurn));
    scale.decimals = 0;
    return scale;
}

AxisScale logarithmicScale(const Interval &range, double intervals)
{
    return {.step = std::max(1.0, nextRoundNumber(range.length() / std::max(intervals, 1.0))), .isLogarithmic = true};
}

Interval roundedOutwards(const Interval &range)
{
    const double largest = largestMagnitude(range);
    // A relative difference below this limit is a rounding error.
    constexpr double kSmallestPart = 1e-12;
    if (!(range.length() > kSmallestPart * largest)) {
        const double half = largest > 0.0 ? 0.1 * largest : 1.0;
        const double middle = 0.5 * range.lower + 0.5 * range.upper;
        return roundedOutwards({middle - half, middle + half});
    }
    constexpr double kRoom = 0.03;
    constexpr double kParts = 16.0;
    const double step = nextRoundNumber(range.length() / kParts);
    const double room = kRoom * range.length();
    // A margin below zero would suggest negative values.
    const double lower = range.lower == 0.0 ? 0.0 : std::floor((range.lower - room) / step) * step;
    return {lower, std::ceil((range.upper + room) / step) * step};
}

} // namespace slidercrank
