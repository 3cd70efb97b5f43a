// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/quantity_text.h"

#include "core/mechanism/channel.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <array>

namespace slidercrank
{

namespace
{

struct QuantityText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::QuantityText)
};

/// Shortens an input for a quotation in a message.
QString quoted(const QString &text)
{
    constexpr int kMaxLength = 24; // characters
    const QString line = text.simplified();
    return line.size() > kMaxLength ? line.first(kMaxLength) + "…" : line;
}

} // namespace

Quantity readQuantity(const QString &text, const std::optional<Unit> &wanted, const QLocale &locale)
{
    const QByteArray bytes =
        text.trimmed().replace(locale.negativeSign(), "-").replace(locale.decimalPoint(), ".").toUtf8();
    return readQuantity({bytes.constData(), static_cast<std::size_t>(bytes.size())}, wanted);
}

QStringList unitsFor(const Unit &wanted)
{
    QStringList units;
    switch (wanted.dimension) {
    case Dimension::Length: units = {"mm", "cm", "m", "km", "in", "ft", "yd"}; break;
    case Dimension::Angle: units = {"deg", "rad", "rev"}; break;
    case Dimension::Time: return {"s", "ms", "min"};
    }
    constexpr std::array kPerTime{"", "/s", "/s^2"}; // indexed by Unit::order
    for (QString &unit : units) {
        unit += QLatin1String(kPerTime[static_cast<std::size_t>(wanted.order)]);
    }
    if (wanted.dimension == Dimension::Angle && wanted.order == static_cast<int>(Order::Velocity)) {
        units += {"rpm", "Hz"};
    }
    return units;
}

QString unitAfterNumber(const Unit &unit)
{
    for (const QString &name : unitsFor(unit)) {
        if (parseUnit(name.toStdString()) == unit) {
            return ' ' + name;
        }
    }
    return {};
}

QString quantityFaultText(const QString &text, QuantityFault fault, const std::optional<Unit> &wanted)
{
    switch (fault) {
    case QuantityFault::NotANumber: return QuantityText::tr("“%1” is not a number.").arg(quoted(text));
    case QuantityFault::CommaForPoint: {
        const QString sign = QLocale().decimalPoint();
        const QString asDecimal = quoted(text).replace(u',', sign);
        static const QRegularExpression thousands(R"((?<!\d)[1-9]\d{0,2},\d{3}(?!\d))");
        if (text.contains(thousands)) {
            return QuantityText::tr("A comma is not accepted: write %1, or %2 if it separates thousands.")
                .arg(asDecimal, quoted(text).remove(u','));
        }
        return QuantityText::tr("Write the decimal sign as “%1”: %2.").arg(sign, asDecimal);
    }
    case QuantityFault::TooLarge: return QuantityText::tr("“%1” is too large.").arg(quoted(text));
    case QuantityFault::UnknownUnit:
    case QuantityFault::WrongUnit: break;
    }
    return wanted ? QuantityText::tr("“%1”: use a unit such as %2.")
                        .arg(quoted(text), unitsFor(*wanted).join(QuantityText::tr(", ")))
                  : QuantityText::tr("“%1”: enter this number without a unit.").arg(quoted(text));
}

} // namespace slidercrank
