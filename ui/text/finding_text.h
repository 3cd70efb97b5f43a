// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Channels, parameters and the result of a comparison in words, the same in the window, on the command line and in the
// report. Numbers in QLocale(), with units.

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

/// "θ³", "ω³", "Rₓ⁴", "v⁴"; the crank angle is "θ₂", as in the controls. Derivatives have letters of their own: fonts
/// misplace the dots of θ̇, and d²θ³/dt² looks like a cube.
QString symbolOf(Channel channel);

/// "coupler angle", "slider velocity".
QString quantityOf(Channel channel);

/// "theta3", "R4_x_diff".
QString columnNameOf(Channel channel);

/// "mm/s²", "°".
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

/// From the unit of the core to the one that is displayed: θ₂₀ in degrees.
double shownFactor(Parameter parameter);

/// That unit, with the space that belongs before it.
QString unitBehind(Parameter parameter);

/// "a = 20 mm".
QString equationText(Parameter parameter, double value, int digits = 6);

/// A parameter to so many significant digits, trailing zeros left out, with the unit in which people think of it:
/// "65 mm", "6.28319 rad/s", "-30°".
QString parameterText(Parameter parameter, double value, int digits = 6);

/// "a = 20 mm, b = 60 mm, c = 25 mm, ω₂ = 6.28319 rad/s, θ₂₀ = 0°, open assembly".
QString mechanismText(const Mechanism &mechanism, int digits = 6);

/// What differs in a pinned mechanism: "b = 65 mm, crossed assembly", or "pinned" if nothing does.
QString pinnedText(const Parameters &pinned, const Parameters &present);

/// A value down to the first digit of its standard error: "20.000001 ± 0.000003". The value alone if there is no
/// standard error (NaN), or only that of rounding numbers of size `scale`.
QString measuredText(double value, double standardError, double scale);

/// "agrees within the rounding of the file", "close: within 12 times the rounding of the file", "differs".
QString verdictText(const ChannelComparison &channel);

/// The rules for verdicts, and the numbers of this channel; several lines.
QString verdictFormula(const ChannelComparison &channel);

/// The verdict on a file: "Match: 6 of 6 quantities agree within the rounding of the file."
QString summaryOf(std::span<const ChannelComparison> channels);

} // namespace slidercrank
