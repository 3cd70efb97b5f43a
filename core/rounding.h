// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a program rounded a column of numbers when it wrote them: to so many significant digits, or to so many decimals.
// Trailing zeros say nothing (139.397000 has six digits), so the rule is inferred from all values of the column.

#include <array>
#include <cstdint>
#include <string_view>

namespace slidercrank
{

/// A column's rule. The step is the distance between neighbouring printable values; a value is off by half of it at most.
struct Rounding {
    enum class Rule {
        Unknown,           ///< no non-zero value to learn from: step 0
        SignificantDigits, ///< the step follows each value's own power of ten
        Decimals           ///< one step for all
    };
    Rule rule = Rule::Unknown;
    int digits = 0;              ///< significant digits, or decimals (negative: tens, hundreds, …)
    double unitFactor = 1.0;     ///< from the file's unit to the author's
    int smallestExponent = 0;    ///< of the column's non-zero values: stands in for a value of zero

    /// The step at a value, both in the author's unit; 0 when unknown.
    double stepAt(double value) const;
};

/// Learns the rule from the numbers as they were printed.
class RoundingObserver
{
public:
    /// `digits`: the cell's text as printed, optional sign, digits with at most one '.' or ',', optional exponent.
    void observe(std::string_view digits);

    Rounding infer(double unitFactor) const;

private:
    // How many values of a decade (first digit's power of ten) had their last non-zero digit at a place (power of ten).
    static constexpr int kLowest = -24;
    static constexpr int kHighest = 24;
    static constexpr int kPlaces = kHighest - kLowest + 1;
    std::array<std::array<std::uint32_t, kPlaces>, kPlaces> m_lastPlaces{};
};

} // namespace slidercrank
