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
    std::string_view label{}; ///< text before the number in each cell: "angle:" of "angle:12.5"
    std::string_view unit{};  ///< unit after the number in each cell
    bool isClock = false;     ///< the cells contain times of a clock
    bool hasDate = false;     ///< the cells contain a date before the time of the clock
    double missing = kNone;   ///< the number that stands for a missing value, such as -9999; NaN: none does
};

/// The heading of a column: "theta3_diff [rad/s]" has the name "theta3_diff" and the unit "rad/s".
struct Heading {
    FileColumn use{};   ///< heading and unit; assignColumns() sets role, channel and reason
    std::string name{}; ///< the heading without its unit
    CellForm cells{};
    NameMeaning meaning{}; ///< of the name and the unit, without regard to other columns
};

/// Splits a cell, given without surrounding quotation marks, into name and unit, and sets the meaning that these have
/// without regard to other columns. The unit fills the heading, or is in brackets of any kind, or at the end, after
/// "/", "in", a comma, a space, a hyphen, an underscore, a full stop, a colon, or as a word that begins with a capital
/// letter, or at the beginning ("Degrees of crank rotation"). Without brackets it must suit the name.
Heading parseHeading(std::string_view cell);

/// Returns what turns the unit of a position into that of its derivative: "/s" makes "mm/s" of "mm".
std::string_view derivativeSuffix(Order order);

/// Returns whether a name begins with a symbol, as "x_B", "θ₂" and "t" do.
bool beginsWithSymbol(std::string_view name);

} // namespace slidercrank
