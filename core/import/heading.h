// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Splits the headings of a table into name and unit. Where a name is ambiguous ("xp"), heading_context.h decides.

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
    FileColumn use{}; ///< heading and unit; assignColumns() sets the rest
    std::string name{};
    CellForm cells{};
    NameMeaning meaning{}; ///< that name and unit have alone
};

/// Splits a cell, given without surrounding quotation marks, into name and unit, and sets the meaning that it has
/// alone. The unit is in brackets of any kind, or at the end, after "/", "in", a comma, a space, a hyphen, an
/// underscore, or as a word that begins with a capital letter. Without brackets it must suit the name.
Heading parseHeading(std::string_view cell);

/// Returns what turns the unit of a position into that of its derivative: "/s" makes "mm/s" of "mm".
std::string_view derivativeSuffix(Order order);

/// Returns whether a name begins with a symbol, as "x_B", "θ₂" and "t" do.
bool beginsWithSymbol(std::string_view name);

} // namespace slidercrank
