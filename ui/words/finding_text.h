// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the core found in a reference file, as a person reads it: the same sentences in the window, on the command line
// and in the report. Numbers in QLocale(), with units; θ³ and Rₓ⁴ as the author writes them, columns by the names of
// his files (theta3, R4_x_diff).

#include "core/comparison/comparison.h"
#include "core/diagnosis/convention.h"
#include "core/diagnosis/diagnosis.h"
#include "core/identification/identification.h"

#include <QString>

#include <array>
#include <span>

namespace slidercrank
{

/// "θ³", "dRₓ⁴/dt": derivatives as quotients, for a dot over a letter is too small to be told from none.
QString symbolOf(Channel channel);

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

/// A parameter to so many significant digits, trailing zeros left out, with the unit in which people think of it:
/// "65 mm", "6.28319 rad/s", "-30°".
QString parameterText(Parameter parameter, double value, int digits = 6);

/// "a = 20 mm, b = 60 mm, c = 25 mm, ω₂ = 6.28319 rad/s, θ₂₀ = 0°, open assembly".
QString mechanismText(const Mechanism &mechanism, int digits = 6);

/// A measured value down to the first digit of its standard error: "20.000001 ± 0.000003". Without a standard error
/// (NaN), or where that is nothing but the rounding of arithmetic on numbers of size `scale`, the value alone.
QString measuredText(double value, double standardError, double scale);

/// A parameter as it was found, with its unit: "60.000000 ± 0.000001 mm"; where only ratios are known, of a:
/// "3.000000 ± 0.000002 a"; a dash for what the data do not fix.
QString measuredText(Parameter parameter, const Identification &found);

/// In words: what the data cannot fix, and how far they are from any mechanism. Empty where there is nothing to say.
QString caveatsOf(const Identification &identification);

/// The parameters with their standard errors, and in words what the data cannot fix, how far the data are from it, or
/// why there is none: "a = 20.000001 ± 0.000003 mm, …, open assembly."
QString summaryOf(const Identification &identification);

/// "Round numbers come as near to the data: a = 20 mm, …". Empty where there are none.
QString roundNumbersText(const Diagnosis &diagnosis);

/// "This error looks like b = 60 instead of 65 mm, which explains 99.9999 % of it." Empty where no single parameter
/// explains nearly all. `mechanism`: the one at hand.
QString changeText(const Diagnosis &diagnosis, const Mechanism &mechanism);

/// A few words: "angle unit".
QString nameOf(const Convention &convention);

/// "theta3 is in radians, but was read as degrees."
QString explanationOf(const Convention &convention);

/// What applying it does, and to what good: "Multiplies theta3 by 57.2958: largest error 0.001 % of peak instead of 98
/// %."
QString effectOf(const ConventionFinding &finding);

/// "agrees within the file's rounding", "close: within 12 × the file's rounding", "differs".
QString verdictText(const ChannelComparison &channel);

/// How that verdict comes about, with this channel's numbers, for a tooltip; three lines.
QString verdictFormula(const ChannelComparison &channel);

/// The verdict on a file: "Agrees with this mechanism in 6 of 6 channels, within the rounding of the file."
QString summaryOf(std::span<const ChannelComparison> channels);

} // namespace slidercrank
