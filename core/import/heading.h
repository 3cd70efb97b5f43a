// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Interprets the heading of a column, as programs and people write it in English or Spanish.

#include "core/import/file_layout.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// The quantity that a name denotes.
struct NameMeaning {
    /// The later kinds are better evidence of a channel.
    enum class Kind {
        Nothing,
        Time,
        Quantity,    ///< of an unnamed body: `channel` is the one that is usually exported
        Words,       ///< for a quantity of a body, which is a channel
        ChannelName, ///< nameOf() a channel
        Chosen       ///< by a person
    };
    Kind kind = Kind::Nothing;
    Channel channel{};
    ColumnReason reason = ColumnReason::UnknownName; ///< why a column with this name is used, or not
    std::string owner{};                             ///< "3.1" in "P[3.1]", "slider" in "slider.s"; empty: none
};

/// The heading of a column: "theta3_diff [rad/s]" has the name "theta3_diff" and the unit "rad/s".
struct Heading {
    FileColumn use{}; ///< heading and unit; assignColumns() sets the role
    std::string name{};
    std::string_view cellUnit{}; ///< after the number in each cell
    bool isClock = false;        ///< the cells contain times of a clock
    bool hasDate = false;        ///< before the time of the clock
    NameMeaning meaning{};       ///< set by interpretHeadings()
};

/// Splits a cell, given without surrounding quotation marks, into name and unit. The unit is at the end, in brackets or
/// parentheses, or after a comma, a space or an underscore.
Heading parseHeading(std::string_view cell);

/// Returns what the name means. If the name does not tell an angle from a length, the unit does.
NameMeaning meaningOf(const Heading &heading);

/// Sets the meanings of a row of headings, including those that depend on others, and why columns are ignored:
///
///     Velocity (cm/s)   X-comp   Y-comp     PMKS+ writes the magnitude of a vector before its components
///     slider.s   slider.a   crank.phi       Modelica: m, rad and s are implied
void interpretHeadings(std::vector<Heading> &row);

} // namespace slidercrank
