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

/// What a name tells.
struct NameMeaning {
    enum class Kind {
        Nothing,
        RowNumber, ///< "n", "index", "Time (steps)": never the time
        Time,
        Channel, ///< exactly one of the 36
        Quantity ///< of an unnamed body: `channel` is the one that is usually exported
    };
    Kind kind = Kind::Nothing;
    Channel channel{};
    bool isExact = false;                 ///< Kind::Channel by nameOf(), not by words
    std::optional<Dimension> dimension{}; ///< none: neither name nor unit tell an angle from a length
    std::string owner{};                  ///< the joint: "3.1" of "P[3.1]", "slider" of "slider.s"; empty: none named
    bool isModelica = false;
};

/// A header cell: "theta3_diff [rad/s]" is printed so, and has the name "theta3_diff" and the unit "rad/s".
struct Heading {
    std::string printed{};
    std::string name{};
    std::string unit{}; ///< empty: none given

    // Set by interpretHeadings().
    NameMeaning meaning{};
    std::optional<std::size_t>
        component{};                ///< the column of the first component of the vector that this is the size of
    bool isFromFileName = false;    ///< name and meaning are those of the file's name
    bool hasUnitOfModelica = false; ///< none is given: the one that such names have in Modelica

    bool isCrankAngle() const
    {
        return meaning.kind == NameMeaning::Kind::Channel && meaning.channel == Channel{Theta2, Order::Position};
    }
};

/// `cell`: without the quotation marks around it; doubled marks within stand for one. The unit stands in brackets or
/// parentheses at the end, or behind a comma, a space or an underscore where it is one.
Heading parseHeading(std::string_view cell);

/// The meaning of a heading by itself. The unit tells angle from length where the name leaves it open, else
/// `dimension`.
NameMeaning meaningOf(const Heading &heading, std::optional<Dimension> dimension = {});

/// Sets the meanings of a row of headings, with what one of them tells of another:
///
///     Velocity (cm/s)   X-comp   Y-comp     PMKS+ writes the magnitude of a vector before its components
///     P[2.1] (deg)   V[2.1]                 Inventor: columns of one joint are all angles, or all lengths
///     slider.s   slider.a   crank.phi       Modelica: in m, rad and s, and the tables do not say so
///
/// Those without a unit get that of all lengths and angles of the file, if one is given. Returns whether any did.
bool interpretHeadings(std::vector<Heading> &row, const std::string &unitOfLengths, const std::string &unitOfAngles);

/// "J1_x", "part 7 velocity": whether a name that means nothing ends in a quantity.
bool endsInQuantity(const Heading &heading);

/// "Value", "Series1", "y": whether any plot may be called so.
bool saysNothing(const Heading &heading);

} // namespace slidercrank
