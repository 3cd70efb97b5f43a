// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How channels, parameters and a comparison read: the same in the window, on the command line and in the report.
// Numbers in QLocale(), with units; θ³ and Rₓ⁴ as the author writes them, columns by the names of his files (theta3,
// R4_x_diff).

#include "core/comparison/comparison.h"

#include <QString>
#include <QStringList>

#include <array>
#include <span>

namespace slidercrank
{

/// "x", "x and y", "x, y and z".
QString listed(const QStringList &words);

/// To three digits; "∞".
QString errorText(double value);

/// "θ³", "ω³", "Rₓ⁴", "v⁴"; the crank's angle is "θ₂" as on the controls. Rates have letters of their own: fonts misplace
/// the dots of θ̇, and d²θ³/dt² reads as a cube.
QString symbolOf(Channel channel);

/// "coupler angle", "slider velocity".
QString quantityOf(Channel channel);

/// "theta3", "R4_x_diff".
QString columnNameOf(Channel channel);

/// Of the author's files: "mm/s²", "°".
QString unitOf(Channel channel);

/// "a", "ω₂".
QString symbolOf(Parameter parameter);

inline constexpr std::array kParameters{Parameter::A, Parameter::B, Parameter::C, Parameter::Omega2,
                                        Parameter::Theta20};

/// In options and JSON: "a", "omega2".
const char *wordOf(Parameter parameter);

/// "open", "crossed".
QString assemblyText(Branch branch);

/// "open assembly".
QString withNoun(Branch branch);

/// From the core's unit to the one in which people think of it: θ₂₀ in degrees.
double shownFactor(Parameter parameter);

/// That unit, with the space that belongs before it.
QString unitBehind(Parameter parameter);

/// A parameter to so many significant digits, trailing zeros left out, with the unit in which people think of it:
/// "65 mm", "6.28319 rad/s", "-30°".
QString parameterText(Parameter parameter, double value, int digits = 6);

/// "a = 20 mm, b = 60 mm, c = 25 mm, ω₂ = 6.28319 rad/s, θ₂₀ = 0°, open assembly".
QString mechanismText(const Mechanism &mechanism, int digits = 6);

/// What a mechanism has that the present one has not: "b = 65 mm, crossed assembly"; "kept" where nothing differs.
QString keptText(const Parameters &kept, const Parameters &present);

/// A measured value down to the first digit of its standard error: "20.000001 ± 0.000003". Without a standard error
/// (NaN), or where that is nothing but the rounding of arithmetic on numbers of size `scale`, the value alone.
QString measuredText(double value, double standardError, double scale);

/// "agrees within the file's rounding", "close: within 12 × the file's rounding", "differs".
QString verdictText(const ChannelComparison &channel);

/// How that verdict comes about, with this channel's numbers, for a tooltip; three lines.
QString verdictFormula(const ChannelComparison &channel);

/// The verdict on a file: "Agrees with this mechanism in 6 of 6 channels, within the rounding of the file."
QString summaryOf(std::span<const ChannelComparison> channels);

} // namespace slidercrank
