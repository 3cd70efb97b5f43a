// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Conventions of the whole file after which the mechanism found is the given one.

#include "core/identification/convention.h"
#include "core/identification/last_fit.h"

#include <vector>

namespace slidercrank
{

/// Conventions of the whole file, and the mechanism that is found in the file when they are applied to it.
struct WholeFileConventions {
    std::vector<ConventionFinding> conventions{};
    Parameters parameters;
    ParameterErrors standardErrors{}; ///< of the parameters
};

/// A different length unit, times in milliseconds, the other sense of rotation, a late start and the other assembly
/// cannot be distinguished from a different mechanism. Returns such conventions only if the mechanism found is the
/// given one after they are applied, and only if one or two of them are sufficient (in a file with θ2: one). Otherwise
/// returns no conventions, and `found` with its `standardErrors`. `data`: the file after all other conventions were
/// applied.
WholeFileConventions findWholeFileConventions(const ReferenceData &data, const Parameters &found,
                                              const ParameterErrors &standardErrors, const Parameters &given);

} // namespace slidercrank
