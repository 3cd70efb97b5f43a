// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/written_number.h"

#include <cmath>
#include <cstdlib>

namespace slidercrank
{

namespace
{

struct Scientific {
    QString mantissa;
    std::optional<int> exponent; ///< none where the machine wrote none
};

/// Of what a locale wrote, such as "1.5e-08".
Scientific partsOf(const QString &number)
{
    const qsizetype e = number.indexOf(u'e', 0, Qt::CaseInsensitive);
    if (e < 0) {
        return {number, std::nullopt};
    }
    return {number.first(e), QLocale().toInt(number.mid(e + 1))};
}

QString digitsOf(double value, int significantDigits)
{
    return localeWithoutGroups().toString(value == 0.0 ? 0.0 : value, 'g', significantDigits);
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
    const auto [mantissa, exponent] = partsOf(digitsOf(value, significantDigits));
    return exponent ? withPowerOfTen(mantissa, *exponent) : mantissa;
}

QString typedNumberText(double value)
{
    const auto [mantissa, exponent] = partsOf(digitsOf(value, QLocale::FloatingPointShortest));
    return exponent ? QStringLiteral("%1e%2").arg(mantissa).arg(*exponent) : mantissa;
}

QString powerOfTen(int exponent)
{
    static const QString kDigits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = exponent < 0 ? QStringLiteral("10⁻") : QStringLiteral("10");
    for (const QChar digit : QString::number(std::abs(exponent))) {
        text += kDigits[digit.digitValue()];
    }
    return text;
}

QString withPowerOfTen(const QString &mantissa, int exponent)
{
    const QString power = powerOfTen(exponent);
    return mantissa == QLocale().toString(1)    ? power
           : mantissa == QLocale().toString(-1) ? QLocale().negativeSign() + power
                                                : QStringLiteral("%1·%2").arg(mantissa, power);
}

QString numberText(std::optional<double> value, int significantDigits)
{
    return value ? numberText(*value, significantDigits) : dash();
}

QString countText(std::size_t count)
{
    const QLocale locale;
    const QString separator = locale.groupSeparator();
    QString text = locale.toString(static_cast<qulonglong>(count));
    constexpr qsizetype kGroup = 3;
    if (const qsizetype first = text.indexOf(separator); !separator.isEmpty() && first > kGroup) {
        text.insert(first - kGroup, separator); // Qt has 1000.000 for a million in Spanish
    }
    return text;
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
