// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Recognizes forms of names that say more than their words: remarks behind a name, the argument of a function, calls of
// functions that differentiate, and quotients.

#include "core/import/unit_text.h"

#include <optional>
#include <string>
#include <string_view>

namespace slidercrank
{

/// Returns the name without a remark about the sensor, the origin or a parameter after it: "piston position from TDC",
/// "piston velocity at 60 rpm".
std::string_view withoutTrailingRemark(std::string_view name);

/// Removes the argument behind a name ("x(t)" becomes "x") and the calls that differentiate it; returns how often these
/// differentiate: "der(x)" of Modelica, "diff(x(t), t, t)", "diff(diff(x(t), t), t)", "D(x)(t)" and "Derivative(x(t),
/// (t, 2))" of computer algebra. Removes no calls if `unit` is not divided by a time: "d(θ)" in mm is a distance.
int takeDerivativeCalls(std::string_view &name, const std::optional<Unit> &unit);

/// Returns whether a name ends with a number in brackets, as that of an element of a list: "x(4)".
bool isElement(std::string_view name);

/// Returns whether a name is that of a motion relative to another point: "v_B/A", but not "slider/a".
bool isRelative(std::string_view name);

/// Returns whether a name is the ratio of two quantities with the same symbol, "omega3/omega2", "t/T", of any quantity
/// to the crank speed, "v_B/ω2", or of a length to that of a link, "x_B/a".
bool isRatio(std::string_view name);

/// Returns whether a name or its unit is that of a derivative with respect to the crank angle: "dx/dθ", "x' (mm/rad)".
bool isOverAngle(std::string_view name, const std::string &unit);

/// Returns whether a name is that of the magnitude of a vector: "|v|", "abs(v)", "Absolute".
bool isMagnitude(std::string_view name);

} // namespace slidercrank
