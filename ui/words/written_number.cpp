// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/words/written_number.h"

#include <cmath>

namespace slidercrank
{

namespace
{

/// "1e-08" is how machines write 1e-8, and "1E-8" how some locales do.
QString withShortExponent(QString number)
{
    const qsizetype e = number.indexOf(QLatin1Char('e'), 0, Qt::CaseInsensitive);
    if (e < 0) {
        return number;
    }
    number[e] = QLatin1Char('e');
    qsizetype digits = e + 1;
    if (digits < number.size() && !number[digits].isDigit()) {
        if (number[digits] == QLatin1Char('+')) {
            number.remove(digits, 1);
        } else {
            ++digits;
        }
    }
    while (digits + 1 < number.size() && number[digits].digitValue() == 0) {
        number.remove(digits, 1);
    }
    return number;
}

} // namespace

QLocale localeWithoutGroups()
{
    QLocale locale;
    locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    return locale;
}

QString numberText(double value, int significantDigits)
{
    return withShortExponent(localeWithoutGroups().toString(value == 0.0 ? 0.0 : value, 'g', significantDigits));
}

QString numberText(std::optional<double> value, int significantDigits)
{
    return value ? numberText(*value, significantDigits) : dash();
}

QString countText(std::size_t count)
{
    return QLocale().toString(static_cast<qulonglong>(count));
}

QString dash()
{
    return QStringLiteral("–");
}

double nextRoundNumber(double value)
{
    constexpr double kSlack = 1e-9; // 0.1 · 20 is 2, whatever its last digit
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double mantissa : {1.0, 2.0, 5.0}) {
        if (mantissa * decade >= value * (1.0 - kSlack)) {
            return mantissa * decade;
        }
    }
    return 10.0 * decade;
}

} // namespace slidercrank
