// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/quantity_text.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace slidercrank
{

namespace
{

struct QuantityText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::QuantityText)
};

/// Replaces the digits and signs of a locale by those of the C locale.
QString withoutLocale(const QString &text, const QLocale &locale)
{
    QString plain = text;
    plain.replace(locale.negativeSign(), "-");
    plain.replace(locale.exponential(), "e", Qt::CaseInsensitive);
    plain.replace(locale.decimalPoint(), ".");
    for (QChar &sign : plain) {
        if (const int digit = sign.digitValue(); sign.isDigit() && digit >= 0) {
            sign = QChar(u'0' + digit);
        }
    }
    return plain;
}

/// Shortens an input for a quotation in a message.
QString quoted(const QString &text)
{
    constexpr int kMost = 24; // characters
    const QString line = text.simplified();
    return line.size() > kMost ? line.first(kMost) + "…" : line;
}

} // namespace

Quantity readQuantity(const QString &text, const std::optional<Unit> &wanted, const QLocale &locale)
{
    const QByteArray bytes = withoutLocale(text.trimmed(), locale).toUtf8();
    return readQuantity({bytes.constData(), static_cast<std::size_t>(bytes.size())}, wanted);
}

Quantity readCount(const QString &text)
{
    const QString separator = QLocale().groupSeparator();
    const QRegularExpression groups(QStringLiteral("^\\d{1,3}(%1\\d{3})+$").arg(QRegularExpression::escape(separator)));
    return readQuantity(groups.match(text).hasMatch() ? QString(text).remove(separator) : text, std::nullopt);
}

QStringList unitsFor(const Unit &wanted)
{
    switch (wanted.dimension) {
    case Dimension::Length: return {"mm", "cm", "m", "in"};
    case Dimension::Angle: return wanted.order == 0 ? QStringList{"deg", "rad"} : QStringList{"rad/s", "deg/s", "rpm"};
    case Dimension::Time: return {"s", "ms"};
    }
    return {};
}

QString quantityFaultText(const QString &text, QuantityFault fault, const std::optional<Unit> &wanted)
{
    switch (fault) {
    case QuantityFault::NotANumber: return QuantityText::tr("“%1” is not a number.").arg(quoted(text));
    case QuantityFault::CommaForPoint: {
        const QString sign = QLocale().decimalPoint();
        return QuantityText::tr("The decimal sign here is “%1”: %2.").arg(sign, quoted(text).replace(u',', sign));
    }
    case QuantityFault::TooLarge: return QuantityText::tr("“%1” is too large.").arg(quoted(text));
    case QuantityFault::UnknownUnit:
    case QuantityFault::WrongUnit: break;
    }
    return wanted ? QuantityText::tr("“%1”: the units here are %2.")
                        .arg(quoted(text), unitsFor(*wanted).join(QuantityText::tr(", ")))
                  : QuantityText::tr("“%1”: no unit belongs to this number.").arg(quoted(text));
}

} // namespace slidercrank
