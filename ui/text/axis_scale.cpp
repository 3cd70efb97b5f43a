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

/// 1, 2 or 5 times a power of ten, at least `step`.
double niceStep(double step)
{
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    const double mantissa = step / power;
    constexpr double kRoundingRoom = 1e-9; // 2.0000000001 is 2
    for (const double nice : {1.0, 2.0, 5.0}) {
        if (mantissa <= nice + kRoundingRoom) {
            return nice * power;
        }
    }
    return 10.0 * power;
}

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
    // A tick near zero is zero: neither -0 nor the 1e-17 that stepping from one end leaves.
    const double shown = std::abs(value) < step * 1e-6 ? 0.0 : value / std::pow(10.0, exponent);
    return locale.toString(shown, 'f', decimals);
}

QString AxisScale::unit(const QString &unit) const
{
    return exponent == 0 ? unit : QStringLiteral("%1 %2").arg(powerOfTen(exponent), unit);
}

int AxisScale::labelLength(const Interval &range) const
{
    if (isLogarithmic) {
        constexpr int kBase = 2;
        const auto exponentLength = [](double value) {
            return static_cast<int>(QString::number(static_cast<int>(std::lround(value))).size());
        };
        return kBase + std::max(exponentLength(range.lower), exponentLength(range.upper));
    }
    const double largest = largestMagnitude(range) / std::pow(10.0, exponent);
    const int integerDigits = largest < 10.0 ? 1 : 1 + static_cast<int>(std::floor(std::log10(largest)));
    return integerDigits + (decimals > 0 ? 1 + decimals : 0) + (range.lower < 0.0 ? 1 : 0);
}

AxisScale axisScale(const Interval &range, double intervals)
{
    AxisScale scale;
    scale.step = niceStep(range.length() / std::max(intervals, 1.0));
    constexpr double kSmallestPlain = 1e-4;
    constexpr double kLargestPlain = 1e5;
    const double largest = largestMagnitude(range);
    if (largest > 0.0 && std::isfinite(largest) && (largest < kSmallestPlain || largest >= kLargestPlain)) {
        scale.exponent = 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
    }
    constexpr double kRoundingRoom = 1e-9;
    constexpr double kMostDecimals = 17.0;
    const double exponentOfStep = std::log10(scale.step) - scale.exponent; // not finite where the range underflows
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
    scale.step = part != kPartsOfATurn.end() ? *part : kTurn * std::max(1.0, niceStep(wanted / kTurn));
    scale.decimals = 0;
    return scale;
}

AxisScale logarithmicScale(const Interval &range, double intervals)
{
    return {.step = std::max(1.0, niceStep(range.length() / std::max(intervals, 1.0))), .isLogarithmic = true};
}

Interval roundedOutwards(const Interval &range)
{
    const double largest = largestMagnitude(range);
    // Below this part of the values a difference is nothing but their rounding.
    constexpr double kSmallestPart = 1e-12;
    if (!(range.length() > kSmallestPart * largest)) {
        const double half = largest > 0.0 ? 0.1 * largest : 1.0;
        const double middle = 0.5 * range.lower + 0.5 * range.upper;
        return roundedOutwards({middle - half, middle + half});
    }
    constexpr double kRoom = 0.03;
    constexpr double kParts = 16.0;
    const double step = niceStep(range.length() / kParts);
    const double room = kRoom * range.length();
    // Room below a range that starts at zero would only suggest negative values.
    const double lower = range.lower == 0.0 ? 0.0 : std::floor((range.lower - room) / step) * step;
    return {lower, std::ceil((range.upper + room) / step) * step};
}

QString shortNumber(double value, int digits, const QLocale &locale)
{
    if (!std::isfinite(value)) {
        return std::isnan(value) ? dash() : value > 0.0 ? QStringLiteral("∞") : QStringLiteral("−∞");
    }
    if (value == 0.0) {
        return locale.toString(0);
    }
    QLocale plain = locale; // groups of three are for counts: beside a decimal comma they mislead
    plain.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator);
    int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (exponent >= -6 && exponent < 6) {
        return plain.toString(value, 'f', std::max(0, digits - 1 - exponent));
    }
    double mantissa = value / std::pow(10.0, exponent);
    const double unit = std::pow(10.0, digits - 1);
    if (std::round(std::abs(mantissa) * unit) >= 10.0 * unit) { // 9.996 is written 1.00·10¹
        mantissa /= 10.0;
        ++exponent;
    }
    return withPowerOfTen(locale.toString(mantissa, 'f', digits - 1), exponent);
}

QString shortNumber(std::optional<double> value, int digits)
{
    return value ? shortNumber(*value, digits) : dash();
}

} // namespace slidercrank
