// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a program rounded a column of numbers when it wrote them: to so many significant digits, or to so many decimals.
// Trailing zeros say nothing (139.397000 has six digits), so the rule is inferred from all values of the column.
// Sixteen digits and more are a double's, and say nothing either: 12.3456000000000003 is 12.3456, the shortest text of
// the same double.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

namespace slidercrank
{

/// A column's rule. The step is the distance between neighbouring printable values; a value is off by half of it at
/// most.
struct Rounding {
    enum class Rule {
        Unknown,           ///< nothing to learn from (only zeros): step 0
        SignificantDigits, ///< the step follows each value's own power of ten
        Decimals           ///< one step for all
    };
    Rule rule = Rule::Unknown;
    int digits = 0;           ///< significant digits, or decimals (negative: tens, hundreds, … of another unit)
    double unitFactor = 1.0;  ///< from the file's unit to the author's
    int smallestExponent = 0; ///< of the column's non-zero values: stands in for a value of zero

    /// Power of ten of the last digit printed anywhere in the column. Six significant digits printed with six decimals
    /// are fewer than six where the value is small: no step is finer than this.
    int finestPlace = std::numeric_limits<int>::min();

    /// And none is coarser than this: 70 beside 40 are whole numbers, not tens.
    int coarsestPlace = std::numeric_limits<int>::max();

    /// The step at a value, both in the author's unit; 0 when unknown.
    double stepAt(double value) const;

    /// The same to as many decimals everywhere as there are at that value: what is to be shifted keeps its decimals, but
    /// not its significant digits.
    Rounding withDecimalsAt(double value) const;

    /// Of the last digit printed anywhere, zero or not, in the author's unit: 1e-6 of 0.005000. 0 when nothing is
    /// known.
    double finestStep() const;

    friend bool operator==(const Rounding &, const Rounding &) = default;
};

/// Rounding::stepAt() of one value after the other: quick where neighbours lie in the same decade, as those of a motion
/// do.
class RoundingSteps
{
public:
    explicit RoundingSteps(const Rounding &rounding)
        : m_rounding(rounding)
    {
    }

    double at(double value)
    {
        const double magnitude = std::abs(value);
        return magnitude >= m_from && magnitude < m_to ? m_step : stepElsewhere(value);
    }

private:
    double stepElsewhere(double value);

    const Rounding &m_rounding;
    double m_from = 0.0; ///< magnitudes from here to there have the step
    double m_to = 0.0;
    double m_step = 0.0;
};

/// Where the digits of a printed number stand, as powers of ten: 0.0120 has its first digit other than zero at -2, the
/// last one at -3, and is printed down to -4.
struct PrintedPlaces {
    bool zero = true; ///< no digit but zeros: first and last mean nothing
    int first = 0;
    int last = 0;
    int printed = 0;
};

/// `digits`: optional sign, digits with at most one '.' or ',', optional exponent.
PrintedPlaces placesOf(std::string_view digits);

/// First and last digit of the shortest text that reads as the same double as `digits`, which stand at `places`.
PrintedPlaces shortestPlaces(PrintedPlaces places, std::string_view digits);

/// Learns the rule from the numbers as they were printed.
///
/// Within a decade (the power of ten of the first digit) a value rounded to a place ends there, or one place earlier in
/// one case of ten, two in one of a hundred. So the coarsest place at which, or before which, clearly more than a
/// quarter of the values of the decade end is no coincidence: the decade was rounded there, if not everywhere. (Some
/// programs print some rows with more digits than others: the coarser half decides what can be promised of the column.)
/// The rule is the one that passes nearest to the places of all decades, each weighing as much as it has values. What
/// it says is never coarser than what is printed: than the coarsest place printed, unless the zeros behind the last
/// digits are too many to be digits themselves, and then than whole numbers, unless those are long ones.
///
/// A column that holds one number throughout is rounded to the last digit of that number, or to a whole number.
class RoundingObserver
{
public:
    /// `digits`: the cell's text as printed, optional sign, digits with at most one '.' or ',', optional exponent.
    void observe(std::string_view digits) { observe(placesOf(digits), digits); }

    /// The same where the places are known already.
    void observe(const PrintedPlaces &places, std::string_view digits);

    /// As if the numbers that `later` saw had been observed after these.
    void add(const RoundingObserver &later);

    Rounding infer(double unitFactor) const;

    /// Of instants, whose digits are no chance: of 0.0333, 0.0667, 0.1 every third ends early. Here the place tells at
    /// which nearly all have ended.
    Rounding inferOfInstants(double unitFactor) const;

private:
    void count(const PrintedPlaces &places, std::string_view digits);
    /// `hasEnded`: whether a decade was rounded to the place before which so many of all its values end.
    Rounding inferWith(bool (*hasEnded)(double some, double all), double unitFactor) const;
    int coarsestPlace(const Rounding &rounding) const;

    static constexpr int kLargestExponent = 48; ///< decades beyond ±48 teach nothing
    static constexpr std::size_t kDecades = 2 * kLargestExponent + 1;
    static constexpr std::size_t kMostDigits = 17; ///< the shortest text of a double has no more
    static constexpr int kDigitsOfADouble = 16;    ///< as many, or more, are a double's own rather than somebody's

    /// By decade and number of digits - 1, from the first to the last that is not zero: how many values.
    std::array<std::array<std::uint32_t, kMostDigits>, kDecades> m_counts{};
    std::uint32_t m_long = 0;        ///< texts of a double's own digits
    std::uint64_t m_values = 0;      ///< other than zero
    std::uint64_t m_zerosBehind = 0; ///< decimals printed in vain: zeros behind the last digit, of all these
    int m_coarsestPlace = std::numeric_limits<int>::min(); ///< printed in any of them
    int m_finestPlace = std::numeric_limits<int>::max();
    int m_smallestExponent = std::numeric_limits<int>::max();
    std::string m_onlyMagnitude; ///< the text, without sign, of the first value that is not zero
    bool m_varies = false;       ///< whether another value that is not zero differs from it
};

// Here, because it is called for each value of a large file.
inline void RoundingObserver::observe(const PrintedPlaces &places, std::string_view digits)
{
    if (places.zero || places.first - places.last + 1 < kDigitsOfADouble) {
        count(places, digits);
        return;
    }
    // To find the shortest text takes as long as to read the number: of very many, some tell enough.
    constexpr std::uint32_t kEnough = 256;
    constexpr std::uint32_t kSoManyth = 16;
    if (m_long < kEnough || m_long % kSoManyth == 0) {
        count(shortestPlaces(places, digits), digits);
    }
    ++m_long;
}

inline void RoundingObserver::count(const PrintedPlaces &places, std::string_view digits)
{
    m_finestPlace = std::min(m_finestPlace, places.printed);
    if (places.zero) {
        return;
    }
    ++m_values;
    m_zerosBehind += static_cast<std::uint64_t>(std::max(std::min(places.last, 0) - places.printed, 0));
    m_coarsestPlace = std::max(m_coarsestPlace, places.printed);
    m_smallestExponent = std::min(m_smallestExponent, places.first);
    if (std::abs(places.first) <= kLargestExponent) {
        const auto decade = static_cast<std::size_t>(places.first + kLargestExponent);
        const auto length = static_cast<std::size_t>(places.first - places.last);
        ++m_counts[decade][std::min(length, kMostDigits - 1)];
    }
    if (!m_varies) {
        const std::string_view magnitude = digits.substr(digits.find_first_not_of("+-"));
        if (m_onlyMagnitude.empty()) {
            m_onlyMagnitude = magnitude;
        } else {
            m_varies = m_onlyMagnitude != magnitude;
        }
    }
}

} // namespace slidercrank
