// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Turns a shape into hypotheses: for each of its mirror images, and each size and unit of time that follows from a
// column, chooses the best interpretation of every column. Scales and origins come from linear regressions.

#include "core/identification/convention.h"
#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// The conventions that a hypothesis assumes, in the order of application. All columns that are not used count as no
/// derivatives, and every free origin as another one.
std::vector<Convention> conventionsOf(const Observations &data, const Hypothesis &hypothesis);

/// Whether a column of the channel may be left out: a derivative, which may be the set speed of the crank, or the
/// centre of a link, which may be its centre of mass.
bool mayBeLeftOut(Channel channel);

/// Whether at most half of the columns are left out, or a position is used.
bool keepsEnough(const Hypothesis &hypothesis);

/// The price of the assumptions of a hypothesis, to be added to its score. One cause has one price, however many
/// columns it changes.
double priceOf(const Observations &data, const Hypothesis &hypothesis);

struct InterpretationOptions {
    /// Interprets columns as their headings say, up to whole turns. Otherwise also with other units, signs, origins and
    /// half turns, and without derivatives that cannot be explained.
    bool isPlain = true;
    Parameters given;     ///< supplies a if the file contains no length, and ω2 if it contains no time
    bool hasSize = false; ///< whether the lengths of the shape are known, and not only their ratios
};

/// Adds the interpretations of a shape that was fitted with free scales and offsets. The scores include the prices.
void addInterpretations(const Observations &data, const Fit &shape, const InterpretationOptions &options,
                        std::vector<Fit> &interpretations);

} // namespace slidercrank
