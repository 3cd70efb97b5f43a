// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Names channels and parameters, and describes the result of a comparison. The window, the command line and the report
// use the same texts. Numbers are written in the default locale, with units.

#include "core/comparison/comparison.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

/// Joins words to a list: "x", "x and y", "x, y and z".
QString listed(const QStringList &words);

/// Joins words to a choice: "x", "x or y", "x, y or z".
QString anyOf(const QStringList &words);

/// Returns an error with three significant digits, "∞", or a dash for nullopt.
QString errorText(std::optional<double> value);

/// Returns the symbol of a channel: "θ³", "ω³", "Rₓ⁴", "v⁴". The crank angle is "θ₂", as in the controls. Derivatives
/// have their own letters because fonts misplace the dot of θ̇, and the superscript of d²θ³/dt² looks like a cube.
QString symbolText(Channel channel);

/// Returns the symbol of a channel in absolute coordinates, which the equations are written in: "θ³", "Rₓ⁴".
QString absoluteSymbolText(Channel channel);

/// Returns the name of a channel: "coupler angle", "slider velocity".
QString quantityName(Channel channel);

/// Returns the name of a channel in files: "theta3", "R4_x_diff".
QString columnName(Channel channel);

/// Returns the unit of a channel in files: "mm/s²", "°".
QString unitText(Channel channel);

/// Returns the name of a parameter: "crank", "initial angle".
QString parameterName(Parameter parameter);

/// Returns the symbol of a parameter: "a", "ω₂".
QString symbolText(Parameter parameter);

/// Returns the name of a parameter in options and JSON: "a", "omega2".
const char *optionName(Parameter parameter);

/// Returns "open" or "crossed".
QString assemblyText(Branch branch);

/// Returns "open assembly" or "crossed assembly".
QString withNoun(Branch branch);

/// Converts a value from the unit of the core to the displayed unit: θ₂₀ from radians to degrees.
double shownFactor(Parameter parameter);

/// Returns the displayed unit, preceded by a space where one is needed.
QString unitBehind(Parameter parameter);

/// Returns an equation such as "a = 20 mm".
QString equationText(Parameter parameter, double value, int digits = 6);

/// Returns the value of a parameter with its displayed unit: "65 mm", "6.28319 rad/s", "-30°". `digits` is the largest
/// number of significant digits; trailing zeros are omitted.
QString parameterText(Parameter parameter, double value, int digits = 6);

/// Returns all parameters: "a = 20 mm, b = 60 mm, c = 25 mm, ω₂ = 6.28319 rad/s, θ₂₀ = 0°, open assembly".
QString mechanismText(const Mechanism &mechanism, int digits = 6);

/// Returns the parameters in which a pinned mechanism differs, with six digits: "b = 65 mm, crossed assembly", or
/// "pinned" if none do.
QString pinnedText(const Parameters &pinned, const Parameters &present);

/// Returns a value rounded to the first digit of its standard error: "20.000001 ± 0.000003". Omits the standard error
/// if it is NaN, infinite, or no larger than the rounding error of numbers of size `scale`.
QString measuredText(double value, double standardError, double scale);

/// Describes a verdict: "agrees within the rounding of the file", "close: at most 12.3 times the rounding of the file".
QString verdictText(const ChannelComparison &channel);

/// Returns where the largest error of a channel is: its time, or the crank angle if the file is indexed by it.
QString placeText(const ChannelComparison &channel, const ReferenceData &file);

/// Returns a table of the errors of each channel against a file, in the units that are shown. The first row contains
/// the headings.
std::vector<QStringList> comparisonTable(std::span<const ChannelComparison> channels, const ReferenceData &file);

/// Summarizes a comparison: "Match. Quantities that agree within the rounding of the file: 6 of 6."
QString summaryText(std::span<const ChannelComparison> channels);

} // namespace slidercrank
