// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a program rounded a column of numbers when it wrote them: to significant digits, to decimals, or to multiples of
// a step such as an encoder's. Trailing zeros say nothing (139.397000 has six digits), so the rule is inferred from all
// values of the column. A number of sixteen digits and more counts as the shortest text of the same double:
// 12.3456000000000003 is 12.3456.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

/// The rule of a column. The step is the distance between neighbouring printable values; a value is off by half of it
/// at most.
struct Rounding {
    enum class Rule {
        Unknown,           ///< nothing to learn from (only zeros): step 0
        SignificantDigits, ///< the step follows the power of ten of each value
        Decimals,          ///< one step, a power of ten
        Multiples          ///< one step, `quantum`
    };
    Rule rule = Rule::Unknown;
    int digits = 0;           ///< significant digits, or decimals (negative: tens, hundreds, … of another unit)
    double unitFactor = 1.0;  ///< from the file's unit to the author's
    int smallestExponent = 0; ///< of the column's non-zero values: stands in for a value of zero

    /// Power of ten of the last digit printed anywhere in the column: no step of significant digits is finer.
    int finestPlace = std::numeric_limits<int>::min();

    /// And none is coarser than this: 70 beside 40 are whole numbers, not tens.
    int coarsestPlace = std::numeric_limits<int>::max();

    double quantum = 0.0; ///< Rule::Multiples, in the file's unit

    /// The step at a value, both in the author's unit; 0 when unknown.
    double stepAt(double value) const;

    /// The same with one step everywhere, that at `value`: what is to be shifted keeps its decimals, but not its
    /// significant digits.
    Rounding withDecimalsAt(double value) const;

    /// Of the last digit printed anywhere, zero or not, in the author's unit: 1e-6 of 0.005000. 0 when unknown.
    double finestStep() const;

    friend bool operator==(const Rounding &, const Rounding &) = default;
};

/// Rounding::stepAt() of many values: quick where neighbours lie in the same decade, as those of a motion do.
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
    double m_from = 0.0; ///< magnitudes from here to m_to have the step
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

/// Learns the rule of a column from its numbers as they were printed.
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
    void observe(PrintedPlaces places, double value);

    Rounding infer(double unitFactor) const;

    /// Of time stamps, whose digits are no chance: of 0.0333, 0.0667, 0.1 every third ends early. Here the place tells
    /// at which nearly all have ended.
    Rounding inferOfInstants(double unitFactor) const;

private:
    static constexpr std::size_t kMostDigits = 17; ///< the shortest text of a double has no more

    struct Decade {
        int exponent = 0;
        std::array<std::uint32_t, kMostDigits> counts{}; ///< by number of digits - 1, from first to last non-zero one
    };

    Rounding inferWith(bool (*hasEnded)(double some, double all), double unitFactor) const;
    int coarsestPlace(const Rounding &rounding) const;

    std::vector<Decade> m_decades;
    std::size_t m_latest = 0;        ///< index of the decade of the value before
    std::uint32_t m_long = 0;        ///< values printed with all digits of a double
    std::uint64_t m_values = 0;      ///< other than zero
    std::uint64_t m_zerosBehind = 0; ///< zeros printed behind the last digit of a decimal, of all these
    int m_coarsestPlace = std::numeric_limits<int>::min(); ///< printed in any of them
    int m_finestPlace = std::numeric_limits<int>::max();
    int m_smallestExponent = std::numeric_limits<int>::max();
    PrintedPlaces m_firstPlaces; ///< of the first value that is not zero
    double m_firstMagnitude = 0.0;
    bool m_varies = false; ///< whether another non-zero value differs from it
};

/// The step of an encoder or converter: the largest number of which all values are multiples, apart from a constant and
/// from what `printedStep` leaves open. Only where it is much coarser than that, no power of ten, and both values and
/// differences of neighbours vary enough to show it: 30, 33, 36 are no multiples but a straight line.
std::optional<double> findQuantum(std::span<const double> values, double printedStep);

} // namespace slidercrank
