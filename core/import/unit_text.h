// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Units as programs write them: "mm", "°/s", "deg/sec", "rad/s²", "m/s^2", "mm/sec**2", "rpm", "ms", "min", "grados",
// "°CA" (degrees of crank angle).

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace slidercrank
{

enum class Dimension { Length, Angle, Time };

struct Unit {
    Dimension dimension = Dimension::Length;
    int order = 0; ///< how often divided by a time

    /// To mm or °, per s to the order. Of a time: how many make a second, so that 5 ms / 1000 are 0.005 to the last
    /// bit.
    double factor = 1.0;

    friend bool operator==(const Unit &, const Unit &) = default;
};

std::optional<Unit> parseUnit(std::string_view text);

/// Whether the word is one of these, which spaces separate.
bool isAmong(std::string_view word, std::string_view words);

struct Spelling {
    std::string_view from;
    std::string_view to;
};

/// The text with the first spelling that fits at each place replaced.
std::string respelled(std::string_view text, std::span<const Spelling> spellings);

} // namespace slidercrank
