// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether a fitted hypothesis explains the file. A small residual is not enough for `identified`: it must be rounding,
// or white in the order of time and of the crank angle. A filter or an interpolation leaves a smooth residual and moves
// the parameters by much more than it.

#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

enum class Residual {
    Rounding,
    White,      ///< noise of at most 15 % of the column's spread
    Systematic, ///< at most 1 % of the column's range
    Unexplained,
    NotUsed
};

/// Largest deviation that a mechanism may have to explain a file approximately, as a part of a column's range.
inline constexpr double kLargestSystematicPart = 0.01;

/// Derivatives that are differences of the positions are off by less, as a part of the spread.
inline constexpr double kLargestDifferencePart = 0.03;

enum class Acceptance { Identified, Approximate, Rejected }; ///< the better, the lower

struct Candidate {
    Fit fit;
    double price = 0.0;
    std::vector<Residual> residuals; ///< by column
    Acceptance acceptance = Acceptance::Rejected;
    bool isExact = false;  ///< only rounding is left
    double distance = 1.0; ///< mean of noise²/spread² over the columns that tell the shape, each 1 at most

    double score() const;
};

/// Judges a fit; the price is that of its hypothesis.
Candidate judgedCandidate(const Observations &data, Fit fit);

/// Accepted before rejected, then by score.
bool isBetter(const Candidate &x, const Candidate &y);

/// Whether the residuals of a derivative are noise, of whatever colour, rather than a function of the crank angle or
/// another signal.
bool looksLikeNoise(const std::vector<double> &residuals, const std::vector<double> &crankAngles);

/// The crank angle in every row, rad.
std::vector<double> crankAngles(const Observations &data, const Hypothesis &hypothesis);

/// The range of a column in its interpretation; of a constant one, that of what moves with it.
double interpretedRange(const Observations &data, const Hypothesis &hypothesis, std::size_t column);

} // namespace slidercrank
