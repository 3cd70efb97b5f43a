// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mirror images of a mechanism, which explain the columns of a file equally well: those in the x axis, in the y
// axis and in both, and for θ3 alone also those with a reversed crank (see the table in convention.h). Each reads the
// columns in its own way.

#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// Returns the images, one of which is the model of the fit, that have the simplest reading of the file. A reading is
/// the simpler the fewer columns are negated or half a turn off; another assembly than that of the given mechanism
/// counts like one such column. The mechanism near the given one comes first.
std::vector<Model> findMirrorImages(const Observations &observations, const Fit &fit, const Parameters &given);

} // namespace slidercrank
