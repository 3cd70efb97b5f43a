// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One fit of all used columns and all rows, with standard errors.

#include "core/identification/drive.h"
#include "core/identification/fit.h"

namespace slidercrank
{

/// The result of fitAllRows().
struct LastFit {
    Observations observations; ///< all rows; the values in those that are excluded are NaN
    Fit fit{};
    Indices excludedRows{};  ///< rows of the observations with an outlier
    bool isExact = false;    ///< rounding explains the residuals of every column
    double dependence = 1.0; ///< dependence of the residuals (noise.h); 1 if isExact

    /// Standard errors of the parameters at t = 0 of the file; NaN or infinite if the fit does not determine them.
    ParameterErrors standardErrors{kNone, kNone, kNone, kNone, kNone};

    /// Covariance of fit.unknowns. If the model does not follow the angle in the file, the angle and the speed of the
    /// crank are those at t = 0 of the file.
    Eigen::MatrixXd covariance{};

    /// The standard error of an unknown by its covariance; NaN if it is not free in the fit.
    double standardErrorOf(Unknown unknown) const;
};

/// Changes the standard errors and the covariance as if a parameter had been multiplied by a factor.
void scaleErrors(LastFit &lastFit, Parameter parameter, double factor);

/// Fits all rows, starting from a fit of some rows. A value is an outlier if its residual is beyond eight robust
/// standard deviations, beyond rounding, and larger than a slight delay of the row explains, and if the residuals of
/// its column jump by as much somewhere. Rows with outliers are excluded before the fit, but not if these are more
/// than 5 % of all rows. The fit is not finite if the mechanism of `start` cannot be assembled in all rows.
/// `possibleErrors`: further errors of the parameters (see freedoms.h). `drive`: supplies the standard error of θ20 if
/// the model follows the angle in the file, and that of ω2 in a run-up.
LastFit fitAllRows(Observations observations, const Fit &start, const ParameterErrors &possibleErrors,
                   const Drive &drive);

/// The parameters at t = 0 of the file, with θ20 in (-π, π]. A value that is as small as an error of the arithmetic
/// becomes 0. In a run-up, θ20 and ω2 follow from `drive`; at an uneven speed, ω2 is the mean speed. If the model
/// follows the angle in the file without a run-up, θ20 is the origin of that angle.
Parameters parametersAtTimeZero(const Model &model, const Observations &observations, const Drive &drive);

} // namespace slidercrank
