// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The notation and the units that a person chose for the window, its figures, reports and tables. This is the only
// place that converts a quantity to what is shown. Commands keep the defaults, which are those of files, except where
// their options choose a notation or units.

#include "ui/text/units.h"
#include "ui/text/written_number.h"

#include <QString>

#include <optional>

namespace slidercrank
{

enum class Symbols {
    AbsoluteCoordinates, ///< Shabana: θ³ from A to B, Rₓ⁴
    Textbook             ///< Norton: θ₃ measured at B, x_B, v_B, a_B
};

enum class CrankSpeedUnit { RadianPerSecond, DegreePerSecond, TurnPerMinute };

/// Returns the factor from rad/s to the unit: 9.549 for rpm.
double crankSpeedFactor(CrankSpeedUnit unit);

/// Returns the unit as it is shown: "rpm".
QString crankSpeedUnitText(CrankSpeedUnit unit);

struct Notation {
    Symbols symbols = Symbols::AbsoluteCoordinates;
    Units units = {};
    CrankSpeedUnit crankSpeed = CrankSpeedUnit::RadianPerSecond;

    friend bool operator==(const Notation &, const Notation &) = default;
};

/// Return and set the chosen notation. Must be called in the thread of the window only.
const Notation &notation();
void setNotation(const Notation &notation);

/// How a channel is shown: shown = factor · value in the unit of files + offset. The offset is that of the textbook's
/// θ₃, which is measured at B: θ³ + 180° on the open branch and θ³ - 180° on the crossed one.
struct ShownScale {
    double factor = 1.0;
    double offset = 0.0;

    double shown(double inFileUnit) const { return factor * inFileUnit + offset; }
    double inFileUnit(double shown) const { return (shown - offset) / factor; }
};
ShownScale shownScale(const OutputChannel &channel, Branch branch, const Notation &chosen = notation());

/// Converts a difference of two values of a channel from the unit of files to the unit that is shown.
std::optional<double> shownDifference(const OutputChannel &channel, std::optional<double> difference);

/// Returns the value of a channel as it is shown, from the core's unit (mm, rad, s).
double shownChannel(const OutputChannel &channel, Branch branch, double value);

/// Returns the unit in which quantities of this kind are shown.
QString shownUnit(Measure measure);
inline QString shownUnit(const OutputChannel &channel)
{
    return shownUnit(measureOf(channel));
}

/// Returns a length (mm) with its unit as it is shown: "65 mm", "2.5 in".
QString lengthText(double length, int digits = kUsualDigits);

/// Returns the symbol of a channel. A coordinate has that of symbolText(Channel), except that the coupler's centre of
/// mass has "G_x", "v_Gx", "a_Gx" (and y) in the notation of textbooks. Derived quantities have "μ", "dμ/dt",
/// "d²μ/dt²"; "s", "ds/dt", "d²s/dt²"; "A_x", "v_Ax", "a_Ax"; "A_y", "v_Ay", "a_Ay".
QString symbolOf(const OutputChannel &channel);

/// Returns the name of a channel: "slider velocity", "transmission angle".
QString nameText(const OutputChannel &channel);

} // namespace slidercrank
