// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/units.h"

#include "core/mechanism/enum_table.h"

namespace slidercrank
{

namespace
{

template <typename Unit>
struct UnitDescription {
    Unit key;
    const char *text;
    double perDefault; ///< how many of it are a mm or a degree
};

constexpr UnitDescription<LengthUnit> kLengthUnits[] = {{LengthUnit::Millimetre, "mm", 1.0},
                                                        {LengthUnit::Centimetre, "cm", 1.0 / 10.0},
                                                        {LengthUnit::Metre, "m", 1.0 / 1000.0},
                                                        {LengthUnit::Inch, "in", 1.0 / 25.4}};
static_assert(isCompleteTable(kLengthUnits, LengthUnit::Inch));

constexpr UnitDescription<AngleUnit> kAngleUnits[] = {{AngleUnit::Degree, "°", 1.0},
                                                      {AngleUnit::Radian, "rad", 1.0 / kDegreesPerRadian}};
static_assert(isCompleteTable(kAngleUnits, AngleUnit::Radian));

const UnitDescription<LengthUnit> &lengthUnit(const Units &units)
{
    return rowOf(kLengthUnits, units.length);
}

const UnitDescription<AngleUnit> &angleUnit(const Units &units)
{
    return rowOf(kAngleUnits, units.angle);
}

/// Returns the unit of a length or of an angle, without the time.
QString baseUnit(Measure measure, const Units &units)
{
    return QString::fromUtf8(isAngular(measure) ? angleUnit(units).text : lengthUnit(units).text);
}

} // namespace

double shownValue(Measure measure, double value, const Units &units)
{
    if (isAngular(measure)) {
        return units.angle == AngleUnit::Radian ? value : value * kDegreesPerRadian;
    }
    return isLinear(measure) ? value * lengthUnit(units).perDefault : value;
}

double fromFileUnit(Measure measure, double value, const Units &units)
{
    return isAngular(measure)  ? value * angleUnit(units).perDefault
           : isLinear(measure) ? value * lengthUnit(units).perDefault
                               : value;
}

double coreValue(Measure measure, double shown, const Units &units)
{
    return shown / shownValue(measure, 1.0, units);
}

QString unitText(Measure measure, const Units &units)
{
    switch (measure) {
    case Measure::Ratio: return {};
    case Measure::Time: return QStringLiteral("s");
    case Measure::Length:
    case Measure::Angle: return baseUnit(measure, units);
    case Measure::Speed:
    case Measure::AngularSpeed: return baseUnit(measure, units) + "/s";
    case Measure::Acceleration:
    case Measure::AngularAcceleration: return baseUnit(measure, units) + "/s²";
    }
    return {};
}

QByteArray asciiUnit(Measure measure, const Units &units)
{
    return unitText(measure, units).replace("²", "^2").replace("°", "deg").toUtf8();
}

QString columnName(const OutputChannel &channel, const Units &units)
{
    const std::string_view name = nameOf(channel);
    const QString text = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    const Measure measure = measureOf(channel);
    const bool isDefault = unitText(measure, units) == unitText(measure);
    return isDefault ? text : text + " [" + QString::fromLatin1(asciiUnit(measure, units)) + ']';
}

QString withUnit(const QString &number, const QString &unit)
{
    return unit == u"°" ? number + unit : (number + u' ' + unit).trimmed();
}

} // namespace slidercrank
