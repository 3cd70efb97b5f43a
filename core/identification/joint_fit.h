// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Fits a further column together with those of a fit.

#include "core/identification/fit.h"

#include <optional>

namespace slidercrank
{

/// Fits column k together with the columns of a fit, starting from `model`, which reads the column. Returns nullopt if
/// no mechanism explains them all. `isGeometryExact`: rounding explains the columns from which the geometry was found.
std::optional<Fit> tryToAddColumn(const Observations &observations, const Fit &fit, const Model &model, Index k,
                                  bool isGeometryExact);

} // namespace slidercrank
