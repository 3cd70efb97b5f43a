// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether the residuals of a column are rounding (the verdict "agrees" of a comparison, see comparison.h), noise or
// systematic.

#include "core/identification/fit.h"

namespace slidercrank
{

/// The largest residuals (rms, relative to the range of a column) with which a mechanism explains the column
/// approximately. The limit is lower for systematic residuals than for noise, because a motion of a different kind
/// leaves them as well: 0.8 % and more if a slider-crank is fitted to a four-bar linkage.
inline constexpr double kLargestNoise = 0.02;
inline constexpr double kLargestSystematicResidual = 0.007;

/// A fit explains the values as well as a different one if its misfit is larger by less than this. The ratio of the
/// likelihoods is less than exp(10) then: even among a thousand fits, chance seldom prefers one by more.
inline constexpr double kMaxMisfitIncrease = 20.0;

/// The largest residual that rounding causes, in bounds of rounding: one for the value itself, and one for the error of
/// the fit, which is seldom larger.
inline constexpr double kMaxResidualInBounds = 2.0;

/// How far the values of fit.columns[indexInFit] may be from the motion because of rounding: half a rounding step of
/// the value, plus the motion during half a rounding step of the abscissa.
Values roundingBounds(const Observations &observations, const Fit &fit, Index indexInFit);

/// The size with which the residuals of fit.columns[indexInFit] are compared: the range of the column. R4_y is
/// constant; its size is twice the length of the crank, about the range of R4_x.
double columnSize(const Observations &observations, const Fit &fit, Index indexInFit);

/// Whether at least 95 % of the residuals of fit.columns[indexInFit] are within a bound, none is beyond ten bounds, and
/// none exceeds the bound by more than 0.5 % of half the range (in a constant column, none exceeds it). The bound is
/// that of rounding, plus the error of the fit itself (see FittedMechanism).
bool isWithinRounding(const Observations &observations, const Fit &fit, Index indexInFit);

/// Whether the residuals of fit.columns[indexInFit] are as small as rounding, although the fit has errors, too: their
/// rms is at most kMaxResidualInBounds times that of the bounds. Difference quotients of rounded values have far larger
/// residuals.
bool isNearRounding(const Observations &observations, const Fit &fit, Index indexInFit);

/// Whether rounding explains the residuals of fit.columns[indexInFit], or their rms, relative to columnSize(), is below
/// kLargestNoise if their signs change like those of noise, or below kLargestSystematicResidual if not.
bool isExplained(const Observations &observations, const Fit &fit, Index indexInFit);

/// Whether rounding explains the residuals of all columns of the fit; false if the fit is not finite.
bool isExact(const Observations &observations, const Fit &fit);

/// Whether a fit explains its columns as well as `best`, a fit of the same columns with at least as many unknowns,
/// does: rounding explains its residuals, or its misfit is higher by less than kMaxMisfitIncrease. As the misfit counts
/// each independent error of systematic residuals several times (dependence() in noise.h), the difference of each
/// column is divided by that number. False if `fit` is not finite.
bool explainsAsWell(const Observations &observations, const Fit &fit, const Fit &best);

/// Whether the file proves that the residuals of the fit are systematic, not rounding or noise: they keep their sign
/// for some rows, or a column was interpolated.
bool isSystematic(const Observations &observations, const Fit &fit);

} // namespace slidercrank
