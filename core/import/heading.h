// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Interprets the headings of a table: splits each into name and unit, and decides what it means. Where a name is
// ambiguous ("xp"), the other headings decide.

#include "core/import/name_meaning.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// How the cells of a column are written.
struct CellForm {
    std::string_view label{}; ///< before the number in each cell: "angle:" of "angle:12.5"
    std::string_view unit{};  ///< after the number in each cell
    bool isClock = false;     ///< the cells contain times of a clock
    bool hasDate = false;     ///< before the time of the clock
    double missing = kNone;   ///< the number that stands for a missing value: -9999
};

/// The heading of a column: "theta3_diff [rad/s]" has the name "theta3_diff" and the unit "rad/s".
struct Heading {
    FileColumn use{}; ///< heading and unit; assignColumns() sets the role
    std::string name{};
    CellForm cells{};
    NameMeaning meaning{}; ///< set by interpretHeadings()
};

/// Splits a cell, given without surrounding quotation marks, into name and unit, and sets the meaning that it has
/// alone. The unit is in brackets of any kind, or at the end, after "/", "in", a comma, a space, a hyphen, an
/// underscore, or as a word that begins with a capital letter. Without brackets it must suit the name.
Heading parseHeading(std::string_view cell);

/// Returns what turns the unit of a position into that of its derivative: "/s" makes "mm/s" of "mm".
std::string_view derivativeSuffix(Order order);

/// Returns whether the name begins with a symbol, as "x_B", "θ₂" and "t" do.
bool beginsWithSymbol(const Heading &heading);

/// Sets the meanings of a row of headings, including those that depend on others, and why columns are ignored:
///
///     Velocity (cm/s)   X-comp   Y-comp     PMKS+ writes the magnitude of a vector before its components
///     slider.s   slider.a   crank.phi       Modelica: m, rad and s are implied
///     x   xp   xpp                          xp is a derivative, because xpp can be nothing else
///     x   y   x   y                         Tracker: two points, of which one may be the slider
void interpretHeadings(std::vector<Heading> &row);

} // namespace slidercrank
