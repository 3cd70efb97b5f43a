// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The name of a column, as programs and people write it in English or Spanish, and what it says of the quantity.

#include "core/import/unit_text.h"
#include "core/mechanism/channel.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// A header cell: "theta3_diff [rad/s]" is printed so, and has the name "theta3_diff" and the unit "rad/s".
struct Heading {
    std::string printed;
    std::string name;
    std::string unit; ///< empty: none given

    std::optional<std::size_t>
        component;                      ///< the column of the first component, where this is the magnitude of a vector
    std::optional<Dimension> dimension; ///< told by another column of the same joint
    bool unitOfModelica = false;        ///< none given: the unit is the one that such names have in Modelica
};

/// `cell`: without the quotation marks around it; doubled marks within stand for one. The unit stands in brackets or
/// parentheses at the end, or behind a comma, a space or an underscore where it is one.
Heading parseHeading(std::string_view cell);

/// What a name tells.
struct NameMeaning {
    enum class Kind {
        Nothing,
        RowNumber, ///< "n", "index", "Time (steps)": never the time
        Time,
        Channel, ///< exactly one of the 36
        Quantity ///< an order, perhaps angle or length, of an unnamed body
    };
    Kind kind = Kind::Nothing;
    Channel channel;      ///< Kind::Channel
    bool isExact = false; ///< Kind::Channel by nameOf(), not by words
    Order order = Order::Position;
    std::optional<Dimension> dimension;
    bool alongY = false; ///< of a length
    std::string owner;   ///< the joint: "3.1" of "P[3.1]", "slider" of "slider.s"; empty: none named
    bool isModelica = false;
};

/// The unit tells angle from length where the name leaves it open.
NameMeaning meaningOf(const Heading &heading);

/// "theta2", "Crank angle", "°CA", "CAD", "Kurbelwinkel".
bool isCrankAngle(const Heading &heading);

/// "J1_x", "part 7 velocity": whether a name that means nothing ends in a quantity.
bool endsInQuantity(const Heading &heading);

/// "Value", "Series1", "y": whether any plot may be called so.
bool saysNothing(const Heading &heading);

/// Takes from the names of a row what one of them tells of another:
///
///     Velocity (cm/s)   X-comp   Y-comp     PMKS+ writes the magnitude of a vector before its components
///     P[2.1] (deg)   V[2.1]                 Inventor: columns of one joint are all angles, or all lengths
///     slider.s   slider.a   crank.phi       Modelica: in m, rad and s, and the tables do not say so
void relateHeadings(std::vector<Heading> &row);

/// Gives lengths and angles, and their derivatives, the unit that the file states for all of them, where they have none
/// of their own; an empty unit is none. Returns whether any column was given one.
bool giveUnits(std::vector<Heading> &row, std::string_view ofLengths, std::string_view ofAngles);

} // namespace slidercrank
