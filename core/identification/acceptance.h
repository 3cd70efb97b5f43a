// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Judges whether a fitted hypothesis explains the file. For `identified`, the residuals must be rounding errors or
// noise that is white in the order of time and of the crank angle. A small residual is not enough: a filter or an
// interpolation leaves a smooth residual, and changes the parameters by much more than that.

#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

enum class Residual {
    Rounding,
    White,      ///< white noise of at most 15 % of the column's spread
    Systematic, ///< not white, at most 1 % of the column's range
    Unexplained,
    NotUsed
};

/// The largest deviation of a mechanism that explains a file approximately, relative to a column's range.
inline constexpr double kLargestSystematicPart = 0.01;

/// The largest rms error of derivatives that are differences of the positions, relative to a column's spread.
inline constexpr double kLargestDifferencePart = 0.03;

enum class Acceptance { Identified, Approximate, Rejected }; ///< from best to worst

struct Candidate {
    Fit fit;
    double price = 0.0;
    std::vector<Residual> residuals; ///< by column
    Acceptance acceptance = Acceptance::Rejected;
    bool isExact = false;  ///< rounding explains all residuals
    double distance = 1.0; ///< mean of noise²/spread², each at most 1, over the columns with information on the shape

    double score() const;
};

/// Judges a fit and sets the price of its hypothesis.
Candidate judgedCandidate(const Observations &data, Fit fit);

/// Orders accepted candidates before rejected ones, then by score.
bool isBetter(const Candidate &x, const Candidate &y);

/// Whether the residuals of a derivative are noise, white or not, and neither a function of the crank angle nor another
/// smooth signal.
bool looksLikeNoise(const std::vector<double> &residuals, const std::vector<double> &crankAngles);

/// The crank angle in every row, rad.
std::vector<double> crankAngles(const Observations &data, const Hypothesis &hypothesis);

/// The range of a column in its interpretation; of a constant channel, the size of the parameter that determines it.
double interpretedRange(const Observations &data, const Hypothesis &hypothesis, std::size_t column);

} // namespace slidercrank
