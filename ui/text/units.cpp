// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/units.h"

#include "core/mechanism/enum_table.h"

#include <cmath>

namespace slidercrank
{

namespace
{

struct UnitDescription {
    const char *text;
    double perDefault; ///< factor from mm or degrees to the unit
};

struct LengthUnitRow {
    LengthUnit key;
    UnitDescription unit;
};

constexpr LengthUnitRow kLengthUnitRows[] = {{LengthUnit::Millimetre, {"mm", 1.0}},
                                             {LengthUnit::Centimetre, {"cm", 1.0 / 10.0}},
                                             {LengthUnit::Metre, {"m", 1.0 / 1000.0}},
                                             {LengthUnit::Inch, {"in", 1.0 / 25.4}}};
static_assert(isCompleteTable(kLengthUnitRows, LengthUnit::Inch));

constexpr UnitDescription kDegreeUnit{"°", 1.0};
constexpr UnitDescription kRadianUnit{"rad", 1.0 / kDegreesPerRadian};

const UnitDescription &lengthUnit(const Units &units)
{
    return rowOf(kLengthUnitRows, units.length).unit;
}

/// Returns whether an angle or its derivative is in radians, per s or s².
bool isInRadians(Measure measure, const Units &units)
{
    switch (units.angle) {
    case AngleUnit::Degree: return false;
    case AngleUnit::Radian: return true;
    case AngleUnit::DegreeAndRadianPerSecond: break;
    }
    return measure != Measure::Angle;
}

/// Returns the unit of an angle; for its derivatives the unit without "/s": "rad" of "rad/s".
const UnitDescription &angleUnit(Measure measure, const Units &units)
{
    return isInRadians(measure, units) ? kRadianUnit : kDegreeUnit;
}

/// Returns the unit of a length or of an angle; for derivatives the unit without "/s": "mm" of "mm/s".
QString baseUnit(Measure measure, const Units &units)
{
    return QString::fromUtf8(isAngular(measure) ? angleUnit(measure, units).text : lengthUnit(units).text);
}

} // namespace

LengthUnit lengthUnitWithSize(double millimetres)
{
    constexpr double kTolerance = 1e-9; // relative rounding error of a computed factor
    for (const auto &[unit, description] : kLengthUnitRows) {
        if (std::abs(millimetres * description.perDefault - 1.0) < kTolerance) {
            return unit;
        }
    }
    return LengthUnit::Millimetre;
}

double shownValue(Measure measure, double value, const Units &units)
{
    if (isAngular(measure)) {
        return isInRadians(measure, units) ? value : value * kDegreesPerRadian;
    }
    return isLinear(measure) ? value * lengthUnit(units).perDefault : value;
}

double fromFileUnit(Measure measure, double value, const Units &units)
{
    if (isAngular(measure)) {
        return value * angleUnit(measure, units).perDefault;
    }
    return isLinear(measure) ? value * lengthUnit(units).perDefault : value;
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
    return isDefault ? text : nameWithAsciiUnit(text, measure, units);
}

QString nameWithAsciiUnit(const QString &name, Measure measure, const Units &units)
{
    const QByteArray unit = asciiUnit(measure, units);
    return unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, QString::fromLatin1(unit));
}

QString withUnit(const QString &number, const QString &unit)
{
    return unit == u"°" ? number + unit : (number + u' ' + unit).trimmed();
}

} // namespace slidercrank
