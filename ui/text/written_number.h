// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Formats numbers in the user's locale, without group separators, which could be mistaken for a decimal sign. A
// negative number is displayed as "−1.5·10⁻⁸" and entered as "-1.5e-8".

#include <QLocale>
#include <QString>

#include <optional>

namespace slidercrank
{

inline constexpr int kUsualDigits = 6;   ///< largest number of significant digits of a value in a text
inline constexpr int kReadoutDigits = 4; ///< significant digits of a readout

/// Formats a value with at most `significantDigits` digits, without trailing zeros. Returns a dash for nullopt.
QString numberText(std::optional<double> value, int significantDigits = kUsualDigits);

/// Formats the bounds of a range with at most `significantDigits` digits. They are rounded inwards, so that both are
/// within the range.
QString lowerBoundText(double value, int significantDigits);
QString upperBoundText(double value, int significantDigits);

/// Formats a value with exactly `digits` significant digits, except that all digits before the decimal sign are
/// written. Values below 1e-6 or from 1e6 on have a power of ten. Returns a dash for nullopt and NaN.
QString shortNumber(std::optional<double> value, int digits = kReadoutDigits);

/// Returns the text that stands for a missing value.
QString dash();

/// Formats a value with exactly `decimals` decimals. A value that rounds to zero has no sign.
QString fixedText(double value, int decimals);

/// Returns the number of digits, 6 to 17, that show how two values differ.
int digitsToTellApart(double x, double y);

/// Formats a value at full precision, as it can be entered: "-1.5e-8".
QString typedNumberText(double value);

/// Returns a value rounded to the first digit of its standard error: "20.000001 ± 0.000003". Omits the standard error
/// if it is NaN, infinite, or no larger than the rounding error of numbers of size `scale`.
QString measuredText(double value, double standardError, double scale);

/// Returns a power of ten: "10⁻⁷".
QString powerOfTenText(int exponent);

/// Returns a mantissa with a power of ten: "1.5·10⁻⁷". A mantissa of 1 is omitted.
QString withPowerOfTen(const QString &mantissa, int exponent);

/// Returns the smallest of …, 1, 2, 5, 10, 20, 50, … that is at least `value`. Requires value > 0.
double nextRoundNumber(double value);

} // namespace slidercrank
