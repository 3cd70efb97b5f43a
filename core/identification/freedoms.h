// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Takes the freedoms of a fit back unless the file needs them. What remains are the findings.

#include "core/identification/fit.h"

namespace slidercrank
{

/// A fit from which freedoms were taken back. Some of these may exist nevertheless, so that its parameters are
/// uncertain.
struct ConstrainedFit {
    Fit fit;
    ParameterErrors possibleErrors{}; ///< how far each parameter moved when freedoms that may exist were taken back
};

/// If the coupler is very long, a different length of it looks like another unit of θ3, and a reversed crank like the
/// opposite sign of R4_x. Returns the fit with the usual unit and the usual sign if this explains the columns, too;
/// otherwise the same fit. If the model follows the angle in the file, θ20 is wrapped to [-π, π).
Fit withUsualReadings(const Observations &observations, Fit fit);

/// Sets each origin to its nearest usual value, one after the other, and fits the other unknowns again: the angle of
/// the crank and θ3 to a multiple of half a turn, lengths to 0. An origin stays free only if the file needs it, which
/// means that all of these hold:
///   1. without it, rounding does not explain the residuals;
///   2. the misfit grows without it, by more than 20 times the dependence of the residuals (see noise.h);
///   3. without it, the residuals of a column are larger than 1 % of its range. This is required if the residuals are
///      systematic or the origin is small (2 % of the range of its column, 1° of the crank), because a filter or an
///      interpolation bends the curve that much, too.
/// The parameters move when an origin is taken back. If it may exist nevertheless, because it is no larger than the
/// rounding steps (an encoder truncates) or the misfit grows as for two standard errors, these changes are added to
/// `earlierErrors`, the possible errors of a ConstrainedFit from which `fit` was made. A fit that is not finite remains
/// as it is.
ConstrainedFit withoutFreedoms(const Observations &observations, Fit fit, const ParameterErrors &earlierErrors = {});

} // namespace slidercrank
