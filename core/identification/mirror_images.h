// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mirror images of a mechanism, which explain the columns of a file equally well: those in the x axis, in the y
// axis and in both, and for θ3 alone also those with a reversed crank (see the table in convention.h). Each reads the
// columns in its own way.

#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// Returns the mirror images of the model of a fit, the model itself included, the one with the simplest reading of the
/// file first. A reading is the simpler the fewer columns are negated or half a turn off; if all columns of lengths or
/// of angles are negated, they count once. An assembly other than the given one, and R4_y that is not c, count like one
/// such column. A displacement, which is a length with a free origin, may have either direction and does not count.
/// Equally simple images are ordered by these questions: whether the assembly and c are those of the given mechanism,
/// whether no displacement is negated, how simple the reading is apart from the assembly, and how near the mechanism is
/// to the given one.
std::vector<Model> rankMirrorImages(const Observations &observations, const Fit &fit, const Parameters &given);

/// Returns the first of rankMirrorImages(), followed by those that read the file in the same way.
std::vector<Model> findSimplestMirrorImages(const Observations &observations, const Fit &fit, const Parameters &given);

} // namespace slidercrank
