// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Names the parameters of a mechanism and writes their values with units.

#include "core/mechanism/mechanism.h"
#include "ui/text/notation.h"

#include <QString>

namespace slidercrank
{

/// Returns the name of a parameter: "crank", "initial angle".
QString parameterName(Parameter parameter);

/// Returns the symbol of a parameter: "a", "ω₂".
QString symbolText(Parameter parameter);

/// Returns the name of a parameter in options and JSON: "a", "omega2".
const char *optionName(Parameter parameter);

/// Returns "open" or "crossed".
QString assemblyText(Branch branch);

/// Returns "open assembly" or "crossed assembly".
QString assemblyPhrase(Branch branch);

/// Returns the factor from the unit of the core to the displayed unit: 57.3 for θ₂₀ in degrees.
double shownFactor(Parameter parameter, const Notation &shown = notation());

/// Returns the displayed unit, preceded by a space where one is needed.
QString unitSuffix(Parameter parameter, const Notation &shown = notation());

/// Returns an equation such as "a = 20 mm".
QString equationText(Parameter parameter, double value, int digits = kUsualDigits, const Notation &shown = notation());

/// Returns the value of a parameter with its displayed unit: "65 mm", "6.28319 rad/s", "-30°". `digits` is the largest
/// number of significant digits; trailing zeros are omitted.
QString parameterText(Parameter parameter, double value, int digits = kUsualDigits, const Notation &shown = notation());

/// Returns an equation for each parameter, and the assembly.
QStringList equationTexts(const Parameters &parameters, int digits = kUsualDigits);

/// Returns all parameters: "a = 20 mm, b = 60 mm, c = 25 mm, ω₂ = 6.28319 rad/s, θ₂₀ = 0°, open assembly".
QString mechanismText(const Mechanism &mechanism, int digits = kUsualDigits);

/// Returns the parameters in which a pinned mechanism differs from the current one, with six digits: "b = 65 mm,
/// crossed assembly", or "pinned" if none do.
QString pinnedText(const Parameters &pinned, const Parameters &current);

} // namespace slidercrank
