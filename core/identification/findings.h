// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/identification/last_fit.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// What the steps before judge() (outcome.h) have found out about a file.
struct Findings {
    Drive drive;
    LastFit lastFit; ///< not finite if no mechanism can be assembled
    std::vector<LeftOutColumn> leftOut;
    std::vector<double> speeds;           ///< the values of ω2 that a table over the crank angle allows, rad/s
    std::vector<Model> otherMirrorImages; ///< mirror images of the last fit that need the same reading of the file
    std::optional<LengthChange> change;   ///< the one wrong length of the given mechanism, if there is one
};

} // namespace slidercrank
