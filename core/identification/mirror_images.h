// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mirror images of a mechanism, which explain the columns of a file equally well: those in the x axis, in the y
// axis and in both, and for θ3 alone also those with a reversed crank (see the table in convention.h). Each reads the
// columns in its own way.

#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// Returns the mirror images of a fit, itself included, the one with the simplest reading of the file first; of equal
/// ones, the one near the given mechanism. A reading is the simpler the fewer columns are negated or half a turn off;
/// if all columns of lengths or of angles are negated, they count once. An assembly other than the given one, and R4_y
/// that is not c, count like one such column. The direction of a displacement does not count, but of equal readings the
/// one is simpler in which it is not negated.
std::vector<Model> rankMirrorImages(const Observations &observations, const Fit &fit, const Parameters &given);

/// Returns the first of rankMirrorImages(), and those that read the file in the same way.
std::vector<Model> findSimplestMirrorImages(const Observations &observations, const Fit &fit, const Parameters &given);

} // namespace slidercrank
