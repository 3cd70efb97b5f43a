// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether rounding explains the residuals of a column: the verdict "agrees" of a comparison (comparison.h).

#include "core/identification/fit.h"

namespace slidercrank
{

/// The largest residual (rms, of the range of the column) with which a mechanism explains a column approximately.
inline constexpr double kLargestResidual = 0.02;

/// How far the values of fit.columns[k] may be off by their rounding: half a rounding step of the value, plus the
/// motion during half a rounding step of the abscissa.
Values roundingBounds(const Observations &observations, const Fit &fit, Index k);

/// The size with which the residuals of fit.columns[k] are compared: its range, or a, because R4_y is constant.
double sizeOf(const Observations &observations, const Fit &fit, Index k);

/// Whether at least 95 % of the residuals of fit.columns[k] are within a bound, none is beyond ten bounds, and none
/// exceeds the bound by more than 0.5 % of half the range. The bound is that of rounding, plus the error of the fit
/// itself (see FittedMechanism).
bool isWithinRounding(const Observations &observations, const Fit &fit, Index k);

/// Whether that is so for all columns of the fit.
bool isExact(const Observations &observations, const Fit &fit);

} // namespace slidercrank
