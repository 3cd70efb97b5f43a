// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/expression.h"

#include "ui/text/quantity_text.h"

#include <QRegularExpression>

#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

/// Evaluates a text without spaces by recursive descent: a sum of products of factors.
class Calculator
{
public:
    explicit Calculator(const QString &text)
        : m_rest(text)
    {
    }

    /// Returns the value, or NaN if the text is not an expression.
    double value()
    {
        const double result = sum();
        return m_rest.isEmpty() ? result : kNone;
    }

private:
    /// Removes the sign if it comes next. Returns whether it did.
    bool takes(QChar sign)
    {
        const bool isNext = m_rest.startsWith(sign);
        m_rest = m_rest.sliced(isNext ? 1 : 0);
        return isNext;
    }

    /// Removes a sum from the text and returns its value; NaN if it is not valid.
    double sum()
    {
        double result = product();
        while (true) {
            if (takes(u'+')) {
                result += product();
            } else if (takes(u'-')) {
                result -= product();
            } else {
                return result;
            }
        }
    }

    /// Removes a product from the text and returns its value.
    double product()
    {
        double result = factor();
        while (true) {
            if (takes(u'*')) {
                result *= factor();
            } else if (takes(u'/')) {
                result /= factor();
            } else {
                return result;
            }
        }
    }

    /// Removes a factor from the text and returns its value: a number, π, a sum in parentheses, or a factor with a
    /// minus sign.
    double factor()
    {
        if (m_depth > kMaxDepth) {
            return kNone;
        }
        if (takes(u'-')) {
            ++m_depth;
            return -factor();
        }
        if (takes(u'(')) {
            ++m_depth;
            const double result = sum();
            return takes(u')') ? result : kNone;
        }
        if (takes(u'p')) { // "pi"
            return takes(u'i') ? std::numbers::pi : kNone;
        }
        static const QRegularExpression number(R"(^(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)");
        const QRegularExpressionMatch match = number.match(m_rest);
        m_rest = m_rest.sliced(match.capturedLength());
        const double value = match.hasMatch() ? match.captured().toDouble() : kNone;
        return m_rest.startsWith(u'p') ? value * factor() : value; // "2pi"
    }

    static constexpr int kMaxDepth = 50; // signs and parentheses
    QString m_rest;
    int m_depth = 0; ///< number of signs and parentheses so far
};

} // namespace

Quantity readExpression(const QString &text, const std::optional<Unit> &wanted, const QLocale &locale)
{
    const Quantity quantity = readQuantity(text, wanted, locale);
    if (!quantity.fault) {
        return quantity;
    }
    QString spelled = text.trimmed().replace("pi", "pi", Qt::CaseInsensitive); // "PI" and "Pi" become "pi"
    spelled.replace(locale.negativeSign(), "-").replace(locale.decimalPoint(), ".");
    spelled.replace(QChar(0x2212), "-").replace(u'×', "*").replace(u'·', "*").replace(u'÷', "/").replace(u'π', "pi");
    static const QRegularExpression expression(R"(^((?:[-+*/().\d\s]|pi|[eE][-+]?\d)*)(.*)$)");
    const QRegularExpressionMatch match = expression.match(spelled);
    QString calculation = match.captured(1);
    static const QRegularExpression calculationSign("[*/+(]|\\d\\s*-|pi");
    if (!calculation.contains(calculationSign)) { // the fault is that of the number
        return quantity;
    }
    // "6 1/2" is a sum. Other spaces between digits separate thousands, of which each has three.
    static const QRegularExpression mixedNumber(R"((?<![\d.])(\d+)\s+(\d{1,2}/\d{1,3})(?![\d.]))");
    calculation.replace(mixedNumber, "(\\1+\\2)");
    static const QRegularExpression severalNumbers(R"([\d.]\s+(?!\d{3}(?!\d))[\d.])");
    const double value = Calculator(QString(calculation).remove(QRegularExpression("\\s"))).value();
    if (!std::isfinite(value) || calculation.contains(severalNumbers)) {
        return {.fault = QuantityFault::NotANumber};
    }
    return readQuantity(QString::number(value, 'g', 17) + u' ' + match.captured(2), wanted, QLocale::c());
}

} // namespace slidercrank
