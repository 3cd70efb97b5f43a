// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks numbers of a calculation by hand, for one position of the mechanism, and finds the slip that gives exactly
// these numbers.
//
// A value is right if the exact value rounds to it: if its deviation d is at most h, half a unit of its last digit. A
// rounding error of zero, such as 3·10⁻¹⁴ mm/s at a dead centre, counts as zero.
//
// Every slip of slips.h predicts all values. It fits if it gives every wrong value to its digits. It is named only if
//
//  - it does not contradict the right values: a wrong input or a different way to measure that would change a right
//    position is no explanation. A wrong formula may have been used for some values only; but a slip that leaves all
//    right values right is preferred to it;
//  - no other slip fits; and
//  - chance is unlikely. Of all numbers that are at most as far off as the wrong one, the fraction h/d rounds to the
//    digits that the slip predicts. So n slips fit k wrong values by chance with a probability of at most
//
//        n · h₁/d₁ · … · h_k/d_k,
//
//    which must be below kLargestChance. The size of a slip is the product of the changes that it makes to the k wrong
//    values. n counts the slips that change every wrong value and are no larger than the slip that fits: a larger slip
//    cannot fit numbers that are no farther off. Slips of the same size count once.
//
// Pairs of slips are not tried. A textbook may measure θ3 at B, from B to A (Norton). That is half a turn more than the
// angle at A of this program, no error: θ3 is compared modulo 180°.

#include "core/check/slips.h"

#include <span>
#include <vector>

namespace slidercrank
{

/// A slip is named only if the probability that it fits by chance is below this.
inline constexpr double kLargestChance = 0.04;

/// A number of the calculation by hand.
struct GivenValue {
    OutputChannel channel;
    double value = 0.0;    ///< mm, rad, s
    double halfStep = 0.0; ///< half a unit of its last digit
};

struct CheckedValue {
    GivenValue given;

    /// The given value minus the exact one; for an angle, reduced to within half a turn. NaN if the exact value does
    /// not exist.
    double deviation = kNone;
    bool isRight = false;
    bool isMeasuredAtB = false; ///< θ3 is given as the direction from B to A
};

/// What is known about the wrong values.
enum class CheckOutcome {
    NotNeeded,      ///< all values are right
    SingleSlip,     ///< exactly one slip gives the wrong values
    Ambiguous,      ///< several slips give them
    TooFewDigits,   ///< a slip gives them, but they have too few digits to exclude a coincidence
    RoundedEarlier, ///< no slip is named, but the deviations are within the error of intermediate results that are
                    ///< rounded to three digits
    None            ///< no slip gives them
};

struct CheckResult {
    Status status = Status::Solved;        ///< if it is not Solved, values may not exist
    std::vector<CheckedValue> values = {}; ///< one for each given value
    CheckOutcome explanation = CheckOutcome::NotNeeded;
    std::vector<Slip> slips = {}; ///< one if SingleSlip, several if Ambiguous, otherwise none
};

/// Checks the values at this position. Values that do not exist there are wrong, and are not explained.
CheckResult check(const CrankPosition &position, std::span<const GivenValue> given);

} // namespace slidercrank
