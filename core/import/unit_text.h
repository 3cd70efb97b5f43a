// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Parses units as programs write them: "mm", "°/s", "deg/sec", "rad/s²", "m s^-2", "mm/sec**2", "rpm", "ms", "grados",
// "°CA" (degrees of crank angle).

#include <optional>
#include <string>
#include <string_view>

namespace slidercrank
{

enum class Dimension { Length, Angle, Time };

struct Unit {
    Dimension dimension = Dimension::Length;
    int order = 0; ///< how often it is divided by a time: 2 for mm/s²

    /// Factor to mm or °, per s to the power of `order`. For a unit of time it is the reciprocal, the number of units
    /// in a second, so that 5 ms / 1000 gives exactly 0.005.
    double factor = 1.0;

    /// Converts a value to the default unit.
    double toDefault(double value) const { return dimension == Dimension::Time ? value / factor : value * factor; }

    friend bool operator==(const Unit &, const Unit &) = default;
};

/// Parses a length or an angle, divided by a time at most twice, or a time. A power of ten may be before it. 1/s is
/// rad/s, Hz turns per second. Returns nullopt for other texts.
std::optional<Unit> parseUnit(std::string_view text);

/// Removes the text up to the next `separator`, and the separator, from `rest`. Returns the text without the separator.
std::string_view takeUntil(char separator, std::string_view &rest);

/// Returns whether `word` is one of the words in a list separated by spaces.
bool isAmong(std::string_view word, std::string_view words);

inline char lowerCase(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Returns the text with its ASCII letters in lower case.
std::string lowered(std::string_view text);

} // namespace slidercrank
