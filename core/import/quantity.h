// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A number as a person writes it, alone or with a unit behind it: "25", "2.5cm", "1 in", "60 rpm", "−30°",
// "1 000 mm", "1.5·10⁻⁸". With a decimal point; who reads in a locale brings its signs to these first.

#include "core/import/unit_text.h"
#include "core/mechanism/channel.h"

#include <limits>
#include <optional>
#include <string_view>

namespace slidercrank
{

inline constexpr Unit kMillimetre{Dimension::Length, 0, 1.0};
inline constexpr Unit kDegree{Dimension::Angle, 0, 1.0};
inline constexpr Unit kRadian{Dimension::Angle, 0, kDegreesPerRadian};
inline constexpr Unit kDegreePerSecond{Dimension::Angle, 1, 1.0};
inline constexpr Unit kRadianPerSecond{Dimension::Angle, 1, kDegreesPerRadian};
inline constexpr Unit kTurnPerMinute{Dimension::Angle, 1, 6.0};
inline constexpr Unit kSecond{Dimension::Time, 0, 1.0};

enum class QuantityFault {
    NotANumber,    ///< nothing, words, "20/3"
    CommaForPoint, ///< "30,5"; "1,234.5" and "1,234,567" are no numbers
    TooLarge,      ///< beyond a double
    UnknownUnit,   ///< "3 feet"
    WrongUnit,     ///< "3 s" where a length is wanted, any unit where none is
};

struct Quantity {
    double value = std::numeric_limits<double>::quiet_NaN(); ///< NaN: a fault
    std::optional<QuantityFault> fault;
};

/// `wanted`: the unit of the number that comes back, and of one that stands alone; without it there is none.
Quantity readQuantity(std::string_view text, const std::optional<Unit> &wanted);

} // namespace slidercrank
