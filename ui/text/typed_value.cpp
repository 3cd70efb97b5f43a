// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/typed_value.h"

#include "core/import/cells.h"
#include "core/mechanism/turn.h"
#include "ui/text/check_text.h"
#include "ui/text/expression.h"
#include "ui/text/quantity_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct TypedValueText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::TypedValueText)
};

/// Returns whether many other numbers would mean an angle that rounds to the same digits: an angle of more than a turn,
/// such as 154 rad, or one with few digits, such as 1 rad, which stands for everything between 29° and 86°.
bool isCommonAngle(const TypedValue &typed)
{
    const GivenValue given = typed.given();
    return measureOf(typed.channel) == Measure::Angle &&
           (std::abs(given.value) > kTurn || given.halfStep > kLargestChance * kQuarterTurn);
}

/// Returns the unit behind the number of a text that is a quantity; empty if there is none. The number is as long as
/// possible: the unit of "45.1in" is not ".1in".
std::string_view unitBehindNumber(std::string_view text)
{
    for (std::size_t end = text.size(); end > 0; --end) {
        const std::string_view unit = trimmed(text.substr(end));
        if (parseUnit(unit) && !readQuantity(text.substr(0, end), {}).fault) {
            return unit;
        }
    }
    return {};
}

CheckResult checkAll(const std::vector<TypedValue> &values, const CrankPosition &position)
{
    std::vector<GivenValue> given(values.size());
    std::ranges::transform(values, given.begin(), &TypedValue::given);
    return check(position, given);
}

/// Reads the typed text again, taking its number as radians if `units` are degrees, and as degrees if they are radians.
TypedValue inOtherAngleUnit(const TypedValue &typed, const Units &units)
{
    Units otherUnits = units;
    const bool isInRadians = shownValue(measureOf(typed.channel), 1.0, units) == 1.0;
    otherUnits.angle = isInRadians ? AngleUnit::Degree : AngleUnit::Radian;
    return readTypedValue(typed.text, typed.channel, otherUnits);
}

/// Returns how far the size of a value is from that of the exact one (in the core's unit): 0 if they are equal, log 2
/// if one is twice the other.
double sizeDifference(const TypedValue &typed, double exact)
{
    return std::abs(std::log(std::abs(typed.given().value / exact)));
}

} // namespace

GivenValue TypedValue::given() const
{
    return {.channel = channel, .value = toCore(parsed.value), .halfStep = toCore(parsed.halfStep)};
}

double TypedValue::toCore(double value) const
{
    return unit.toDefault(value) / toFileUnit(measureOf(channel), 1.0);
}

double TypedValue::fromCore(double value) const
{
    return toFileUnit(measureOf(channel), value) / unit.toDefault(1.0);
}

QString TypedValue::unitSuffix() const
{
    return unitName == u"°" ? unitName : u' ' + unitName;
}

TypedValue readTypedValue(const QString &text, const OutputChannel &channel, const Units &units)
{
    const Measure measure = measureOf(channel);
    TypedValue typed;
    typed.channel = channel;
    typed.text = text.simplified();
    typed.unit = {.dimension = isAngular(measure) ? Dimension::Angle : Dimension::Length,
                  .order = static_cast<int>(orderOf(channel)),
                  .factor = 1.0 / fromFileUnit(measure, 1.0, units)};
    typed.unitName = unitText(measure, units);
    const std::string number = typed.text.toStdString();
    typed.parsed = readWrittenValue(number, typed.unit);
    const std::string_view unit = unitBehindNumber(number);
    typed.hasUnit = !unit.empty();
    if (!typed.parsed.fault && typed.hasUnit) {
        typed.unit = parseUnit(unit).value_or(typed.unit);
        typed.unitName = QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
        typed.parsed = readWrittenValue(number, typed.unit);
    }
    return typed;
}

std::vector<TypedValue> inLikelyUnits(std::vector<TypedValue> values, const CrankPosition &position, const Units &units)
{
    const std::vector<CheckedValue> checked = checkAll(values, position).values;
    std::vector<TypedValue> inOtherUnit = values; // here the wrong ω and α are in the other unit
    std::vector<double> exact(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        exact[i] = values[i].given().value - checked[i].deviation;
        const bool mayBeInOtherUnit =
            !values[i].hasUnit && isAngular(measureOf(values[i].channel)) && !checked[i].isRight;
        if (!mayBeInOtherUnit) {
            continue;
        }
        const TypedValue other = inOtherAngleUnit(values[i], units);
        if (checkAll({other}, position).values.front().isRight && !isCommonAngle(other)) {
            values[i] = inOtherUnit[i] = other;
        } else if (orderOf(other.channel) != Order::Position) {
            inOtherUnit[i] = other;
        }
    }
    if (checkAll(values, position).explanation == CheckOutcome::SingleSlip) {
        return values;
    }
    if (checkAll(inOtherUnit, position).explanation == CheckOutcome::SingleSlip) {
        return inOtherUnit;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (sizeDifference(inOtherUnit[i], exact[i]) < sizeDifference(values[i], exact[i])) {
            values[i] = inOtherUnit[i];
        }
    }
    return values;
}

QString faultText(const TypedValue &typed)
{
    constexpr int kDigits = 4; // of the number that replaces a fraction, whose rounding is unknown
    const Quantity computed = readExpression(typed.text, typed.unit, QLocale::c());
    if (!computed.fault) {
        return TypedValueText::tr("“%1” does not show to which digit it is rounded: write it as a decimal number, such "
                                  "as %2.")
            .arg(typed.text, numberText(computed.value, kDigits) + typed.unitSuffix());
    }
    return quantityFaultText(typed.text, *typed.parsed.fault, typed.unit);
}

QString exactText(const TypedValue &typed, const CheckedValue &checked)
{
    constexpr int kMinDigits = 4;
    constexpr int kMaxDigits = 17; // a double has no more
    const double exact = typed.parsed.value - typed.fromCore(checked.deviation);
    const int digits = std::clamp(typed.parsed.digits + 1, kMinDigits, kMaxDigits); // one more than the typed value
    return TypedValueText::tr("exact: %1").arg(shortNumber(exact, digits) + typed.unitSuffix());
}

QString verdictText(const TypedValue &typed, const CheckedValue &checked)
{
    return checkedValueText(checked, typed.parsed.digits, typed.fromCore(checked.deviation), typed.unitSuffix());
}

} // namespace slidercrank
