// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mirror images of a mechanism that explain the columns of a file equally well, each with its own reading:
//
//     mirrored in the x axis    θ → -θ               c → -c, ω2 → -ω2, θ20 → -θ20
//     mirrored in the y axis    x → -x, θ → π - θ    ω2 → -ω2, θ20 → π - θ20, the other assembly
//     and, for θ3 alone         θ3 → θ3              ω2 → -ω2, θ20 → π - θ20

#include "core/identification/fit.h"

#include <vector>

namespace slidercrank
{

/// Returns the image with the simplest reading first, then those that need the same reading of the file. A reading is
/// simple if few columns have another sign, θ2 and θ3 are not half a turn off, and the assembly is that of the given
/// mechanism; among equally simple ones, the mechanism near the given one comes first.
std::vector<Model> findMirrorImages(const Observations &observations, const Fit &fit, const Parameters &given);

/// The number of columns that have to be read differently than their headings say, for a model with the columns and
/// unknowns of a fit.
int readingCount(const Observations &observations, const Fit &fit, const Model &model);

} // namespace slidercrank
