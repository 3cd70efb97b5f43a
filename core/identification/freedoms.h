// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Takes the freedoms of a fit back unless the file needs them. What remains are the findings.

#include "core/identification/fit.h"

namespace slidercrank
{

/// A fit from which freedoms were taken back. Its parameters are uncertain if the file does not exclude an origin that
/// was taken back.
struct ConstrainedFit {
    Fit fit;
    Unknowns possibleOrigins{}; ///< origins at their usual values, although the file does not exclude other ones

    /// Possible error of each parameter: its changes, added in quadrature, when these origins were set to their usual
    /// values.
    ParameterErrors possibleErrors{};
};

/// If the coupler is very long, a different length of it looks like a different unit of θ3, and a reversed crank like
/// the opposite sign of R4_x. Returns the fit with the usual unit if this explains the columns as well, and with the
/// usual sign if rounding explains its residuals; otherwise the same fit. If the model follows the angle in the file,
/// θ20 is wrapped to [-π, π).
Fit withUsualReadings(const Observations &observations, Fit fit);

/// Sets each origin to its nearest usual value, one after the other, and fits the other unknowns again: θ20 (if the
/// model follows the angle in the file) and the origin of θ3 to a multiple of half a turn, origins of lengths to 0. An
/// origin is not needed, and stays at its usual value, if one of these is true of the fit without it:
///   1. it explains the columns as well (explainsAsWell());
///   2. a filter or an interpolation may have bent the curve as the origin does: the residuals of each column are
///      rounding, or below 1 % of its range, and the origin is small (2 % of the range of its column, 1° of the crank)
///      or the residuals of the fit with the free origin are systematic.
/// An origin that is not needed may exist nevertheless if it changes each column by at most a rounding step (an encoder
/// truncates), or if it is more than two standard errors from its usual value. Then the changes of the parameters by
/// taking it back are possible errors. `earlier`: the result from which `fit` was made; {} if there is none. If columns
/// were added to it, its possible origins are free again at first, so that the possible errors become those that all
/// columns leave; if not, its possible origins and errors are kept. A fit that is not finite remains as it is.
ConstrainedFit withoutFreedoms(const Observations &observations, Fit fit, const ConstrainedFit &earlier = {});

} // namespace slidercrank
