// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers as people read them. Powers of ten are written in one way on the screen, "1.5·10⁻⁸", and in another where
// somebody types: "1.5e-8".

#include <QLocale>
#include <QString>

#include <optional>

namespace slidercrank
{

/// At most so many significant digits, in the user's locale, no trailing zeros, no group separators.
QString numberText(double value, int significantDigits = 6);

/// Every digit, as one types it.
QString typedNumberText(double value);

/// "10⁻⁷"
QString powerOfTen(int exponent);

/// "1.5·10⁻⁷"; a mantissa of 1 is left out.
QString withPowerOfTen(const QString &mantissa, int exponent);

/// A dash for what does not exist.
QString numberText(std::optional<double> value, int significantDigits);
QString dash();

/// In the user's locale, with its groups of three.
QString countText(std::size_t count);

/// The least of … 1, 2, 5, 10, 20, 50 … that is not below the value (> 0): for steps and ranges that read well.
double nextRoundNumber(double value);

/// The user's, without a sign between thousands: such a sign reads as a decimal one to somebody else.
QLocale localeWithoutGroups();

} // namespace slidercrank
