// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

QString toText(double value, char format, int digits)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, format, digits);
}

/// Formats a value, and passes the mantissa and the exponent of a text such as "1.5e-08" to `write`.
template <typename Write>
QString formatted(double value, char format, int digits, Write write)
{
    const QString text = toText(value + 0.0, format, digits); // the sum turns -0 into 0
    const qsizetype e = text.indexOf(u'e', 0, Qt::CaseInsensitive);
    return e < 0 ? text : write(text.first(e), QLocale().toInt(text.mid(e + 1)));
}

int exponentOf(double magnitude)
{
    return static_cast<int>(std::floor(std::log10(magnitude)));
}

/// Returns the exponent of a magnitude that is rounded to `digits` significant digits: 1 for 9.9999 and 4 digits.
int exponentOfRounded(double magnitude, int digits)
{
    const int exponent = exponentOf(magnitude);
    const double next = std::pow(10.0, exponent + 1);
    return magnitude >= next - 0.5 * std::pow(10.0, exponent + 1 - digits) ? exponent + 1 : exponent;
}

/// Returns the smallest number with `significantDigits` digits that is not below the value.
double roundedUp(double value, int significantDigits)
{
    constexpr double kSlack = 1e-9; // of the last digit, so that rounding errors do not change it
    if (value == 0.0) {
        return 0.0;
    }
    const double step = std::pow(10.0, exponentOf(std::abs(value)) + 1 - significantDigits);
    return std::ceil(value / step - kSlack) * step;
}

QString withMinusSign(QString text)
{
    return text.replace(QLocale().negativeSign(), "−");
}

} // namespace

QString withPowerOfTen(const QString &mantissa, int exponent)
{
    const QString power = powerOfTenText(exponent);
    if (mantissa == QLocale().toString(1)) {
        return power;
    }
    if (mantissa == QLocale().toString(-1) || mantissa == u"−1") {
        return "−" + power;
    }
    return QStringLiteral("%1·%2").arg(mantissa, power);
}

QString numberText(std::optional<double> value, int significantDigits)
{
    return value ? withMinusSign(formatted(*value, 'g', significantDigits, withPowerOfTen)) : dash();
}

QString lowerBoundText(double value, int significantDigits)
{
    return numberText(roundedUp(value, significantDigits), significantDigits);
}

QString upperBoundText(double value, int significantDigits)
{
    return numberText(-roundedUp(-value, significantDigits), significantDigits);
}

int digitsToTellApart(double x, double y)
{
    constexpr double kMinDigits = 6.0;
    constexpr double kMaxDigits = 17.0;
    const double digits = 2.0 + std::ceil(std::log10(std::max(std::abs(x), std::abs(y)) / std::abs(x - y)));
    return static_cast<int>(x == y ? kMinDigits : std::clamp(digits, kMinDigits, kMaxDigits));
}

QString typedNumberText(double value)
{
    return formatted(value, 'g', QLocale::FloatingPointShortest, [](const QString &mantissa, int exponent) {
        return QStringLiteral("%1e%2").arg(mantissa).arg(exponent);
    });
}

QString shortNumber(std::optional<double> value, int digits)
{
    if (!value || std::isnan(*value)) {
        return dash();
    }
    if (std::isinf(*value)) {
        return *value > 0.0 ? "∞" : "−∞";
    }
    if (*value == 0.0) {
        return QLocale().toString(0);
    }
    constexpr int kSmallestPlain = -6; // exponents that are written without a power of ten
    constexpr int kLargestPlain = 5;
    const int exponent = exponentOfRounded(std::abs(*value), digits); // 10 for 9.996e9, which is rounded to 1.00e10
    if (exponent < kSmallestPlain || exponent > kLargestPlain) {
        return withMinusSign(formatted(*value, 'e', digits - 1, withPowerOfTen));
    }
    const int decimals = std::max(0, digits - 1 - exponent);
    return withMinusSign(formatted(*value, 'f', decimals, withPowerOfTen));
}

QString fixedText(double value, int decimals)
{
    const bool isZero = std::abs(value) < 0.5 * std::pow(10.0, -decimals);
    return withMinusSign(toText(isZero ? 0.0 : value, 'f', decimals));
}

QString powerOfTenText(int exponent)
{
    QString text = QString::number(exponent);
    for (QChar &character : text) {
        character = character == u'-' ? QChar(u'⁻') : QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹")[character.digitValue()];
    }
    return "10" + text;
}

QString dash()
{
    return "–";
}

double nextRoundNumber(double value)
{
    constexpr double kSlack = 1e-9; // 0.1 · 20 equals 2 except for rounding
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double mantissa : {1.0, 2.0, 5.0}) {
        if (mantissa * decade >= value * (1.0 - kSlack)) {
            return mantissa * decade;
        }
    }
    return 10.0 * decade;
}

QString measuredText(double value, double standardError, double scale)
{
    constexpr double kArithmetic = 1e-13; // relative to the scale: smaller errors are rounding errors
    if (!(standardError > kArithmetic * scale) || std::isinf(standardError)) {
        constexpr int kDigitsAlone = 9;
        return numberText(std::abs(value) > kArithmetic * scale ? value : 0.0, kDigitsAlone);
    }
    constexpr double kRoundedToOne = 0.95; // the smallest number that one digit rounds to 1
    // Exponent of the error after rounding to one digit: 0 for 0.96.
    const int errorExponent = exponentOf(standardError / kRoundedToOne);
    const double unit = std::pow(10.0, errorExponent);
    const double rounded = std::round(value / unit) * unit + 0.0; // never -0
    const double roundedError = std::round(standardError / unit) * unit;
    const int digits = rounded == 0.0 ? 1 : std::max(1, exponentOf(std::abs(rounded)) - errorExponent + 1);
    return QStringLiteral("%1 ± %2").arg(shortNumber(rounded, digits), shortNumber(roundedError, 1));
}

} // namespace slidercrank
