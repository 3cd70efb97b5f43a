// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Compares a column that a fit does not use with the prediction of the fitted model. The factor between the two shows
// the unit and the sign of the column.

#include "core/identification/convention.h"
#include "core/identification/fit.h"

#include <array>
#include <cstddef>
#include <span>

namespace slidercrank
{

/// The factors between a unit and the one that a heading states instead: 1, each of `units` (the first of which is 1),
/// and its inverse.
template <std::size_t count>
constexpr std::array<double, 2 * count - 1> withInverses(const std::array<double, count> &units)
{
    std::array<double, 2 * count - 1> factors{1.0};
    for (std::size_t i = 1; i < count; ++i) {
        factors[2 * i - 1] = units[i];
        factors[2 * i] = 1.0 / units[i];
    }
    return factors;
}

/// The factors that correct a column of angles: 1, or a conversion if radians and degrees were confused.
inline constexpr std::array kAngleFactors = withInverses(kAngleUnits);

/// The largest residual (rms, relative to the range of the column) with which a mechanism explains a column that a fit
/// does not use: much smaller if rounding explains all columns of the fit than if their residuals are noise.
double maxResidualOfFurtherColumn(const Observations &observations, const Fit &fit);

/// The possible ratios of the unit of a column of this channel to the one that its heading states; the first is 1.
std::span<const double> unitFactors(Channel channel);

/// The sign with which a coordinate is counted: that of the first of its columns in the fit, or 1 if there is none.
double signOfCoordinate(const Observations &observations, const Fit &fit, Coordinate coordinate);

/// The factor of a reading with which the motion of a model fits a column best, by least squares. A position may have
/// any origin; a derivative has none.
double bestFactor(const Observations &observations, const Model &model, Index column);

/// How a column that a fit does not use is related to its prediction.
struct ColumnScale {
    /// The prediction has to be multiplied by it. Negative if the column has the opposite sign to the columns of the
    /// same coordinate that the fit uses.
    double factor = kNone;

    /// After multiplication by the factor, rounding explains the residuals, or they are below
    /// maxResidualOfFurtherColumn().
    bool isExplained = false;
    bool isNearRounding = false; ///< these residuals are as small as rounding (residual_test.h)
};

/// Compares a derivative with its prediction by `model`, which is that of the fit at the same or at a different speed
/// of the crank.
ColumnScale fitScale(const Observations &observations, const Fit &fit, const Model &model, Index column);

/// The usual factor of a column, ±1 or ± one of unitFactors(), that is nearest to bestFactor(). Columns that show no
/// factor have 1 (R4_y) or the sign of their coordinate in the fit (other constant columns, except the speed of the
/// crank).
double usualFactor(const Observations &observations, const Fit &fit, Index column);

} // namespace slidercrank
