// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Step 4: takes the freedoms of the geometry back unless the file needs them. What remains are the findings.

#include "core/identification/fit.h"

namespace slidercrank
{

/// A fit, and how uncertain its parameters are because a freedom that was taken back may nevertheless exist.
struct ConstrainedFit {
    Fit fit;
    ParameterErrors shifts{}; ///< what taking freedoms back has changed
};

/// Reads θ3 in its usual unit and R4_x with its usual sign if a very long coupler hides the difference. Then sets each
/// origin to its nearest usual value, one after the other, and fits the other unknowns again: the angle of the crank
/// and θ3 to a multiple of half a turn, lengths to 0. An origin stays free if the file proves it:
///   1. rounding does not explain the residuals without it;
///   2. the misfit without it is higher by more than 20 times the dependence of the residuals (see fit.h);
///   3. it changes a column by more than one rounding step;
///   4. the residuals are noise, or they would be larger than 1 % of the range of a column without the origin: a filter
///      or an interpolation bends the curve, too. `isInterpolated`: the file proves an interpolation.
///   5. it is not small (2 % of the range of the column, 1° of the crank): filters shift a curve that much.
/// `shifts`: of freedoms that were taken back before.
ConstrainedFit withoutFreedoms(const Observations &observations, Fit fit, bool isInterpolated,
                               const ParameterErrors &shifts = {});

} // namespace slidercrank
