// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The name of a column, as programs and people write it, in English or Spanish: what it tells of the quantity.

#include "core/mechanism/channel.h"
#include "core/import/unit_text.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace slidercrank
{

/// A header cell: "theta3_diff [rad/s]" is printed so, and has the name "theta3_diff" and the unit "rad/s".
struct Heading {
    std::string printed;
    std::string name;
    std::string unit; ///< empty: none given

    /// What it is beside others, as the row of names tells (heading_row.h).
    enum class Part {
        Own,
        Abscissa, ///< over which the values of another column stand
        Ordinate, ///< the values of such a pair
        Magnitude ///< of a vector whose components are other columns
    };
    Part part = Part::Own;
    std::optional<std::size_t> other; ///< the other column of a pair, the first component of a magnitude
    bool unitOfModelica = false;      ///< none given: the unit is the one that such names have in Modelica
};

/// `cell`: without the quotation marks around it; doubled marks within stand for one. The unit stands in brackets or
/// parentheses at the end, or behind a comma, a space or an underscore where it is one.
Heading headingOf(std::string_view cell);

/// What a name tells.
struct NameMeaning {
    enum class Kind {
        Nothing,
        RowNumber, ///< "n", "index", "Time (steps)": never the time
        Time,
        Channel,  ///< exactly one of the 36
        Quantity, ///< some of: order, angle or length, of which body
    };
    Kind kind = Kind::Nothing;
    Channel channel;         ///< Kind::Channel
    bool fileName = false;   ///< Kind::Channel by nameOf(), not by words
    bool alongY = false;     ///< Kind::Quantity, of a length
    std::string outputIndex; ///< Inventor's "3.1" of "P[3.1]", Modelica's "slider" of "slider.s"; empty: another name
    bool isModelica = false;
    std::optional<Order> order;
    std::optional<Dimension> dimension;
};

/// The unit tells angle from length where the name leaves it open.
NameMeaning meaningOf(const Heading &heading);

/// "J1_x", "part 7 velocity": whether a name that means nothing ends in a quantity.
bool endsInQuantity(const Heading &heading);

/// "Value", "Series1", "y": whether any plot may be called so.
bool saysNothing(const Heading &heading);

} // namespace slidercrank
