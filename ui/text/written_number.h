// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers as people read them, in the user's locale and without a sign between thousands, which could be taken for a
// decimal sign. Powers of ten are written as "1.5·10⁻⁸", and where somebody types as "1.5e-8".

#include <QLocale>
#include <QString>

#include <optional>

namespace slidercrank
{

/// At most so many significant digits, without trailing zeros.
QString numberText(double value, int significantDigits = 6);

/// So many significant digits; written out between 1e-6 and 1e6.
QString shortNumber(double value, int digits, const QLocale &locale = QLocale());

/// A dash for what does not exist.
QString numberText(std::optional<double> value, int significantDigits);
QString shortNumber(std::optional<double> value, int digits);
QString dash();

/// Every digit, as one types it.
QString typedNumberText(double value);

/// "10⁻⁷"
QString powerOfTen(int exponent);

/// "1.5·10⁻⁷"; a mantissa of 1 is left out.
QString withPowerOfTen(const QString &mantissa, int exponent);

/// With groups of three digits.
QString countText(std::size_t count);

/// The least of … 1, 2, 5, 10, 20, 50 … that is not below the value (> 0).
double nextRoundNumber(double value);

QLocale localeWithoutGroups();

} // namespace slidercrank
