// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Judges whether a fitted hypothesis explains the file. For `identified`, the residuals must be rounding errors or
// white noise. A small residual is not enough: a filter or an interpolation leaves a smooth residual, and changes the
// parameters by much more than that.

#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// Readings beyond so many robust standard deviations are bad.
inline constexpr double kFarReading = 8.0;

/// The standard deviation from zero that normally distributed values with the same median absolute value have.
double robustDeviation(std::vector<double> values);

/// What the residuals of a column are.
enum class Residual {
    NotUsed,
    Rounding,
    White,      ///< white noise of at most 15 % of the column's spread
    Systematic, ///< not white, at most 1 % of the column's range
    Unexplained
};

enum class Acceptance { Identified, Approximate, Rejected }; ///< from best to worst

/// A fit and its judgement.
struct Candidate : Fit {
    double price = 0.0;
    std::vector<Residual> judgements{}; ///< by column
    Acceptance acceptance = Acceptance::Rejected;
    Residual worst = Residual::Unexplained; ///< of all columns
    bool isExact = false;                   ///< rounding explains all residuals
    bool hasFreeOrigin = false;             ///< of a used column, or of the crank angle in the file

    /// The score with the price of the hypothesis.
    double pricedScore() const;
};

/// Judges a fit and sets the price of its hypothesis.
Candidate judgedCandidate(const Observations &data, Fit fit);

/// A smaller offset, relative to the size of the column, describes an error of the values, and not their origin.
inline constexpr double kIdleOffset = 2e-2;

/// Whether the fitted offset of a column is at most a part of its size or, for an angle, so near to a number of half
/// turns.
bool isSmallOffset(const Observations &data, const Hypothesis &hypothesis, std::size_t column, double part);

/// Orders accepted candidates before rejected ones, then by score.
bool isBetter(const Candidate &x, const Candidate &y);

/// Whether a derivative deviates from the motion as one in another unit, with a lag or a filter does, or by noise,
/// white or not, that is neither a function of the crank angle nor another smooth signal.
bool isLikeDifferences(const Observations &data, const Hypothesis &hypothesis, std::size_t column);

} // namespace slidercrank
