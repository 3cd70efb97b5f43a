// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/round_number.h"

#include "core/identification/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace slidercrank
{

namespace
{

/// The decimal place of the first digit of a positive number: 1 for 12.5, -1 for 0.5.
int placeOfFirstDigit(double magnitude)
{
    return static_cast<int>(std::floor(std::log10(magnitude)));
}

/// The nearest multiple of 10^decimalPlace. If this power is a fraction, divides by its inverse, so that the result is
/// the double nearest to the decimal number.
double roundedTo(int decimalPlace, double value)
{
    const double power = std::pow(10.0, std::abs(decimalPlace));
    return (decimalPlace < 0 ? std::round(value * power) / power : std::round(value / power) * power) + 0.0; // never -0
}

/// A decimal number times a unit.
struct Decimal {
    double value = 0.0;
    int digits = 0; ///< number of digits from the first to the last one that is not zero
};

/// The number with the fewest digits within a tolerance of a value: a multiple of the largest possible power of ten.
/// nullopt if this power is smaller than `minSpacing`. Requires |value| > tolerance.
std::optional<Decimal> shortestDecimal(double value, double tolerance, double minSpacing)
{
    const int highest = placeOfFirstDigit(std::abs(value) + tolerance) + 1;
    for (int decimalPlace = highest; std::pow(10.0, decimalPlace) >= minSpacing; --decimalPlace) {
        const double rounded = roundedTo(decimalPlace, value);
        if (std::abs(rounded - value) <= tolerance) {
            return Decimal{rounded, placeOfFirstDigit(std::abs(rounded)) - decimalPlace + 1};
        }
    }
    return std::nullopt;
}

/// The number that a person may have chosen for a value, see findRoundNumber(). nullopt if there is none.
std::optional<Decimal> findChosenNumber(double value, double standardError, std::span<const double> units)
{
    // A multiple of 10^decimalPlace is within the tolerance by chance with the probability
    // 2 tolerance / 10^decimalPlace.
    constexpr double kMaxChance = 0.1;
    const double tolerance = kStandardErrors * standardError;
    const double minSpacing = 2.0 * tolerance / kMaxChance;
    if (std::abs(value) <= tolerance) { // most offsets and angles are 0 by choice
        return Decimal{};
    }
    std::optional<Decimal> best;
    for (const double unit : units) {
        const std::optional<Decimal> decimal = shortestDecimal(value / unit, tolerance / unit, minSpacing / unit);
        if (decimal && (!best || decimal->digits < best->digits)) {
            best = Decimal{decimal->value * unit, decimal->digits};
        }
    }
    return best;
}

} // namespace

RoundNumber findRoundNumber(double value, double standardError, std::span<const double> units)
{
    if (!(standardError > 0.0) || std::isinf(standardError)) {
        return {value};
    }
    if (const std::optional<Decimal> chosen = findChosenNumber(value, standardError, units)) {
        return {.value = chosen->value, .isChosen = true, .digits = chosen->digits};
    }
    const double unit = units.front();
    return {.value = roundedTo(placeOfFirstDigit(standardError / unit), value / unit) * unit};
}

RoundNumber roundLength(double value, double standardError, double unit)
{
    constexpr int kDigits = 15; // 6 in are 152.4 mm, and not 152.39999999999998 mm
    const bool isPowerOfTen = std::fmod(std::log10(unit), 1.0) == 0.0;
    if (isPowerOfTen) { // a round number of metres is one of millimetres, too
        return findRoundNumber(value, standardError, std::array{1.0});
    }
    RoundNumber rounded = findRoundNumber(value, standardError, std::array{unit});
    if (rounded.value != 0.0) {
        rounded.value = roundedTo(placeOfFirstDigit(std::abs(rounded.value)) + 1 - kDigits, rounded.value);
    }
    return rounded;
}

} // namespace slidercrank
