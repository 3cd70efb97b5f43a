// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The round number that a person may have chosen for a value which is known with an error.

#include <span>

namespace slidercrank
{

/// A number with few digits near a value.
struct RoundNumber {
    double value = 0.0;
    bool isChosen = false; ///< a person may have chosen it: it is 0, or an equally round number is near by chance with
                           ///< a probability of at most 10 %
    int digits = 0;        ///< if `isChosen`: number of digits from the first to the last one that is not zero, in the
                           ///< unit that needs the fewest; 0 for zero
};

/// The number with the fewest digits that is within three standard errors of a value, where digits are counted in the
/// unit among `units` that needs the fewest; 0 if the value is within three standard errors of 0. If that number is not
/// so round that a person may have chosen it (RoundNumber::isChosen), returns the value rounded to the first digit of
/// its standard error, in the first of `units`. Returns the value itself if its standard error is 0, infinite or NaN.
RoundNumber findRoundNumber(double value, double standardError, std::span<const double> units);

/// The result of findRoundNumber() for a length and its standard error in mm, in a unit of `unit` mm.
RoundNumber roundLength(double value, double standardError, double unit);

} // namespace slidercrank
