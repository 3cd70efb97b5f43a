// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From a shape to hypotheses: each of its images in each size and unit of time that the columns tell, and for each of
// these the best interpretation of every column. Nothing is fitted here: scales and origins are read off regressions.

#include "core/identification/fit.h"

#include <stop_token>
#include <vector>

namespace slidercrank
{

enum class Interpretations {
    Plain,   ///< as the headings say
    Offsets, ///< with free origin offsets and half turns
    All      ///< with other units and signs, too; derivatives that fit no way may be left out
};

/// What may be claimed costs a price in units of the score; the same cause in several columns is paid for once.
double priceOf(const Observations &data, const Hypothesis &hypothesis);

struct Interpretation {
    Hypothesis hypothesis;
    double misfit = 0.0; ///< with the price, lower is better
};

struct InterpretationOptions {
    Interpretations allowed = Interpretations::Plain;
    Parameters given; ///< supplies the crank's length where the file holds no length, and ω2 where it holds no time
    bool isShortArc = false; ///< the shape may have to follow its valley until scales are 1 and offsets 0
    std::stop_token stop;
};

/// Adds the interpretations of a shape fitted with free scales and offsets.
void addInterpretations(const Observations &data, const Fit &shape, const InterpretationOptions &options,
                        std::vector<Interpretation> &interpretations);

} // namespace slidercrank
