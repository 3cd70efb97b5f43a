// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// By which factor a column that a fit does not use differs from the prediction of its model: its unit and its sign.

#include "core/identification/fit.h"

#include <array>
#include <span>

namespace slidercrank
{

/// What a column of angles may have to be multiplied by because radians and degrees were confused.
inline constexpr std::array kAngleUnits{1.0, kDegreesPerRadian, 1.0 / kDegreesPerRadian};

/// The largest residual with which a mechanism explains a further column: rms, relative to the range of the column. If
/// the mechanism explains the other columns exactly (within rounding), the further column may have hardly any residual.
double largestFurtherResidual(bool othersAreExact);

/// The factors by which a column may be in a different unit than its heading says; the first is 1.
std::span<const double> unitFactors(Channel channel);

/// The sign with which a coordinate is counted: that of the first of its columns in the fit, or 1 if there is none.
double signOfCoordinate(const Observations &observations, const Fit &fit, Coordinate coordinate);

/// The factor with which a prediction fits a column best, and what remains.
struct ColumnScale {
    double factor = kNone;    ///< negative if the column is counted in the opposite sense to its coordinate in the fit
    bool isExplained = false; ///< the residuals of the prediction times the factor are rounding or small
};

/// Compares a column that `fit` does not use with the prediction of `model`, which is that of the fit at the same or at
/// another speed of the crank.
ColumnScale fitScale(const Observations &observations, const Fit &fit, const Model &model, Index column,
                     bool othersAreExact);

/// The usual factor, ±1 or a unit conversion, that is nearest to the one with which the prediction fits a column.
double usualFactor(const Observations &observations, const Fit &fit, Index column);

} // namespace slidercrank
