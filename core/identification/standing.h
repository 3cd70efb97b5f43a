// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether a fitted mechanism explains its data, and how well they fix it. A small residual is not enough: what is left
// must be rounding, or look like noise.

#include "core/identification/motion_fit.h"

#include <array>

namespace slidercrank
{

/// How much of a column's spread noise may be: of the kinds that look like noise, and of the kind that need not, the
/// errors of a program that integrated.
inline constexpr double kMostNoise = 0.15;
inline constexpr double kIntegrationError = 3e-4;

/// Lag-1 autocorrelation of the values of a column, those missing left out.
double correlationOf(const std::vector<double> &values);

struct Standing {
    bool stands = false;
    bool isExact = false;   ///< rounding explains all of it
    double inflation = 1.0; ///< of the standard errors, where what is left is correlated
    std::vector<bool> columnStands;
};

/// How far a fit is from the plotted columns: mean of σ²/spread², each counting 1 at most, as what is left out does. 1
/// explains nothing.
double distanceOf(const FitProblem &problem, const Fit &fit);

/// A column with noise stands where its residuals change sign as chance does, in the order of time and in the order of
/// the crank's angle, and where harmonics of that angle explain no more of them than chance. Fewer than twenty rows
/// tell no noise from misfit: there rounding must explain all.
Standing standingOf(const FitProblem &problem, const Fit &fit);

/// What a fit is worth. Lengths, speed and angle in FitUnits.
struct Uncertainty {
    std::array<double, kParameterCount> standardError{}; ///< of θ20 at the middle of the data; NaN where held
    double atClockZero = 0.0;                            ///< standard error of θ20 at the file's t = 0
    double conditionNumber = 0.0;
    bool isStraight = false; ///< three standard errors in any direction cost what a parabola would, within a factor 2
    double evidence = 0.0;   ///< how much better than chance the values are met, in nats
};

Uncertainty uncertaintyOf(const Observations &observations, const FitProblem &problem, const Fit &fit,
                          const FreeParameters &isFree, const Standing &standing);

} // namespace slidercrank
