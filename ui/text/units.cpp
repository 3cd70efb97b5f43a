// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/units.h"

#include <array>

namespace slidercrank
{

namespace
{

struct UnitDescription {
    const char *text;
    double perDefault; ///< how many of it are a mm or a degree
};

/// By LengthUnit.
constexpr std::array<UnitDescription, 4> kLengthUnits{
    {{"mm", 1.0}, {"cm", 1.0 / 10.0}, {"m", 1.0 / 1000.0}, {"in", 1.0 / 25.4}}};

/// By AngleUnit.
constexpr std::array<UnitDescription, 2> kAngleUnits{{{"°", 1.0}, {"rad", 1.0 / kDegreesPerRadian}}};

const UnitDescription &lengthUnit(const Units &units)
{
    return kLengthUnits[static_cast<std::size_t>(units.length)];
}

const UnitDescription &angleUnit(const Units &units)
{
    return kAngleUnits[static_cast<std::size_t>(units.angle)];
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
