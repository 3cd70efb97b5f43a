// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The units in which quantities are shown and written. All conversions between them and the core's mm, rad and s are
// here.

#include "core/limits/output_channel.h"

#include <QString>

namespace slidercrank
{

enum class LengthUnit { Millimetre, Centimetre, Metre, Inch };
enum class AngleUnit {
    Degree,
    Radian,
    DegreeAndRadianPerSecond ///< angles in °, their derivatives in rad/s and rad/s², as in most textbooks
};

/// The units of lengths and angles; derivatives are per s and s². The defaults are those of files.
struct Units {
    LengthUnit length = LengthUnit::Millimetre;
    AngleUnit angle = AngleUnit::Degree;

    friend bool operator==(const Units &, const Units &) = default;
};

/// Returns the unit that is this many millimetres long: Inch for 25.4. Returns Millimetre if there is no such unit.
LengthUnit lengthUnitWithSize(double millimetres);

/// Converts a value from the core's unit (mm, rad, s).
double shownValue(Measure measure, double value, const Units &units = {});

/// Converts a value from the unit of files (mm, °, s), which a Trajectory has.
double fromFileUnit(Measure measure, double value, const Units &units);

/// Converts a value to the core's unit.
double coreValue(Measure measure, double shown, const Units &units = {});

/// Returns the unit as it is shown: "mm", "in/s", "rad/s²", "°", "s"; empty for a ratio.
QString unitText(Measure measure, const Units &units = {});

/// Returns the unit in ASCII, as it follows the name of a column: "in/s^2", "rad/s".
QByteArray asciiUnit(Measure measure, const Units &units);

/// Returns the name of the channel in files: "R4_x_diff", "transmission_angle", with its unit if that is not the one of
/// files: "R4_x_diff [in/s]".
QString columnName(const OutputChannel &channel, const Units &units = {});

/// Returns the name in a CSV with the unit of its values: "R4_x_diff [mm/s]", "theta2 [deg]"; a ratio has none.
QString nameWithAsciiUnit(const QString &name, Measure measure, const Units &units);

/// Returns "60°" or "60 mm": a number and its unit.
QString withUnit(const QString &number, const QString &unit);

} // namespace slidercrank
