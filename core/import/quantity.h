// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Parses a number as a person writes it, with or without a unit: "25", "2.5cm", "1 in", "60 rpm", "−30°", "1 000 mm",
// "1.5·10⁻⁸". The decimal sign is a point. Numbers in the format of a locale have to be converted first.

#include "core/import/unit_text.h"
#include "core/mechanism/channel.h"

#include <optional>
#include <string_view>

namespace slidercrank
{

inline constexpr Unit kMillimetre{Dimension::Length, 0, 1.0};
inline constexpr Unit kDegree{Dimension::Angle, 0, 1.0};
inline constexpr Unit kRadian{Dimension::Angle, 0, kDegreesPerRadian};
inline constexpr Unit kDegreePerSecond{Dimension::Angle, 1, 1.0};
inline constexpr Unit kRadianPerSecond{Dimension::Angle, 1, kDegreesPerRadian};
inline constexpr Unit kRadianPerSquareSecond{Dimension::Angle, 2, kDegreesPerRadian};
inline constexpr Unit kTurnPerMinute{Dimension::Angle, 1, 6.0};
inline constexpr Unit kSecond{Dimension::Time, 0, 1.0};

enum class QuantityFault {
    NotANumber,    ///< empty, words, "20/3"
    CommaForPoint, ///< "30,5"; but "1,234.5" and "1,234,567" are NotANumber
    TooLarge,      ///< for a double
    UnknownUnit,   ///< "3 miles"
    WrongUnit,     ///< "3 s" if a length is expected, or any unit if none is expected
};

struct Quantity {
    double value = kNone; ///< NaN if there is a fault
    std::optional<QuantityFault> fault;
};

/// Returns the value in the unit `expected`, which is assumed if the text has none. Without `expected`, a unit is a
/// fault.
Quantity readQuantity(std::string_view text, const std::optional<Unit> &expected);

} // namespace slidercrank
