// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Adds a column to a fit: all of its columns are fitted together.

#include "core/identification/fit.h"

#include <optional>

namespace slidercrank
{

/// Fits column k together with the columns of a fit, starting from `model`, which reads the column. Returns nullopt if
/// no mechanism explains them all.
std::optional<Fit> tryToAddColumn(const Observations &observations, const Fit &fit, const Model &model, Index k);

/// Fits column k together with the columns of a fit, in the simplest reading with which a mechanism explains them all:
/// in its usual one, with a different sign or unit, or else with a free origin. Returns nullopt if there is none, or if
/// the column only contains difference quotients of another one.
std::optional<Fit> addInSimplestReading(const Observations &observations, const Fit &fit, Index k);

} // namespace slidercrank
