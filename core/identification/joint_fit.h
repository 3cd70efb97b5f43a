// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Adds a column to a fit, by fitting all columns together.

#include "core/identification/fit.h"

#include <optional>

namespace slidercrank
{

/// Fits column k together with the columns of a fit. The unknowns are those of the fit; they start at their values in
/// `model`, which also contains the reading of column k. Returns nullopt if no mechanism explains all of these columns.
std::optional<Fit> tryToAddColumn(const Observations &observations, const Fit &fit, const Model &model, Index k);

/// Fits column k together with the columns of a fit, in the simplest reading of column k with which a mechanism
/// explains all of them: the usual one, one with a different sign or unit, or else one with a free origin. Returns
/// nullopt if there is none, or if the column only contains difference quotients of a different column.
std::optional<Fit> addInSimplestReading(const Observations &observations, const Fit &fit, Index k);

} // namespace slidercrank
