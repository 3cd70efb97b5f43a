// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Infers how a program rounded a column of numbers when it wrote them: to significant digits, to decimals, or to
// multiples of a step, such as that of an encoder. Trailing zeros carry no information (139.397000 has six digits), so
// the rule is inferred from all values of the column. A number with 16 or more digits is treated as the shortest text
// of the same double: 12.3456000000000003 is 12.3456.
//
// The place of a digit is its power of ten: in 12.3, the last digit is at the place -1.

#include <array>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

/// The rounding rule of a column. The step is the distance between neighbouring printable values; rounding changes a
/// value by at most half a step.
struct Rounding {
    enum class Rule {
        Unknown,           ///< all values are zero: the step is 0
        SignificantDigits, ///< the step depends on the power of ten of each value
        Decimals,          ///< one step for all values, a power of ten
        Multiples          ///< one step for all values, `quantum`
    };
    Rule rule = Rule::Unknown;
    int digits = 0;          ///< number of significant digits or of decimals (negative: rounded to tens, hundreds, …)
    double unitFactor = 1.0; ///< from the unit of the file to the default unit
    int smallestExponent = 0; ///< smallest power of ten of the non-zero values; used for a value of zero

    /// Place of the last digit printed anywhere in the column: no step of significant digits is finer.
    int finestPlace = INT_MIN;

    /// No step is coarser than this power of ten: next to 40, 70 is a whole number and not a multiple of ten.
    int coarsestPlace = INT_MAX;

    double quantum = 0.0; ///< step of Rule::Multiples, in the unit of the file

    /// Returns the step at a value, both in the default unit; 0 if it is unknown.
    double stepAt(double value) const;

    /// Returns a rule with the step at `value` for all values. Shifting a column preserves its decimals, but not its
    /// significant digits.
    Rounding withDecimalsAt(double value) const;

    /// Returns the step of the last printed digit, even if it is zero, in the default unit: 1e-6 for 0.005000. 0 if
    /// the rule is unknown.
    double finestStep() const;

    friend bool operator==(const Rounding &, const Rounding &) = default;
};

/// Returns 10^exponent; 0 or infinity outside the range of a double.
double powerOfTen(int exponent);

/// Places of the digits of a printed number. For 0.0120, the first non-zero digit is at -2, the last one at -3, and the
/// last printed digit at -4.
struct PrintedPlaces {
    bool isZero = true; ///< all digits are zero; `firstNonZero` and `lastNonZero` have no meaning
    int firstNonZero = 0;
    int lastNonZero = 0;
    int lastPrinted = 0;
};

struct RoundedDecade;

/// Infers the rule of a column from its numbers as they were printed.
///
/// A value ends at its last non-zero digit. Take the values of one decade (with the same power of ten of the first
/// digit). If they are rounded at one place, one value in ten ends one place earlier, and one in a hundred two places
/// earlier; in a table of a formula, many more end early by chance, such as those at 30°, 60° and 90°. So the place of
/// rounding is the coarsest one by which nine of ten values have ended. If the numbers are padded with zeros, it is the
/// coarsest one by which clearly more than a quarter have ended: some programs print some rows with more digits than
/// others, and the rule describes those with fewer digits.
///
/// The rule of the column is the one that is closest to the places of all decades, weighted by their numbers of values.
/// The rule is never coarser than the coarsest printed place, unless the largest values, at least six, all end earlier
/// (-2120, beside 853); if the numbers are padded with zeros, it is never coarser than whole numbers, unless it has
/// many significant digits.
///
/// A value that repeats the one before it says nothing new: a mechanism may stand still. If a column repeats one
/// number, it is rounded at the last digit of that number, or to a whole number.
class RoundingObserver
{
public:
    /// What the numbers of a column mean.
    enum class Content { Quantity, TimeStamps };

    /// Adds the next number of the column. `printed`: the places of its digits in the file.
    void observe(const PrintedPlaces &printed, double value);

    /// Infers the rule. The digits of time stamps are not random: in 0.0333, 0.0667, 0.1, every third ends early. So
    /// the place by which nine of ten have ended is used also if they are padded.
    Rounding infer(double unitFactor, Content content) const;

private:
    /// Returns whether the numbers were padded with zeros, as in 139.397000: at least half of the values end with
    /// zeros, with at least a quarter of a zero per value plus four zeros.
    bool isPadded() const;

    /// Returns the places at which the values of all decades were rounded, from the smallest decade.
    std::vector<RoundedDecade> roundedDecades(Content content) const;

    /// Returns the coarsest place that a step of the rule may have. `largest`: the decade of the largest values.
    int coarsestPlaceOf(const Rounding &rounding, const RoundedDecade &largest, Content content) const;

    static constexpr std::size_t kMaxDigits = 17; ///< in the shortest text of a double
    static constexpr int kLargestExponent = 48;   ///< larger and smaller powers of ten are not regarded

    /// Numbers of values, by the power of ten of their first digit (from -kLargestExponent), and by the number of
    /// digits from the first to the last non-zero one, less 1.
    std::array<std::array<std::uint32_t, kMaxDigits>, 2 * kLargestExponent + 1> m_decades{};

    std::uint64_t m_values = 0;        ///< number of values that are not zero and differ from the one before
    std::uint64_t m_trailingZeros = 0; ///< number of zeros printed after the last non-zero decimal of these values
    std::uint64_t m_paddedValues = 0;  ///< number of these values that end with such zeros
    int m_coarsestPlace = INT_MIN;     ///< largest place of the last printed digit of these values
    int m_finestPlace = INT_MAX;       ///< smallest place of the last printed digit of any number, also of 0
    int m_smallestExponent = INT_MAX;  ///< smallest power of ten of the first digit of these values
    PrintedPlaces m_lastPlaces;        ///< of the last of these values
    double m_lastMagnitude = 0.0;      ///< of the last of these values
};

/// Returns the step of an encoder or converter: the largest number such that all values are multiples of it, apart from
/// a constant and an uncertainty of `printedStep`. Returns nullopt unless the step is much coarser than `printedStep`
/// and no power of ten, and both the values and their differences vary enough to show it: 30, 33, 36 are points of a
/// straight line, not multiples of 3.
std::optional<double> findQuantum(std::span<const double> values, double printedStep);

/// Returns 5, 0.5, 0.05 … if all values are multiples of it, as read from a scale, but not of the next power of ten.
/// `rounding` is that of their printed digits. Returns nullopt for few different values, which may be so by chance.
std::optional<double> findStepOfFive(std::span<const double> values, const Rounding &rounding);

} // namespace slidercrank
