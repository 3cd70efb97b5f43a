// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All that can be found out about a file held against a mechanism, one after the other: the conventions by which it
// reads otherwise than it says, then, with those applied, the one parameter that explains the difference and the
// mechanism that the file belongs to.

#include "core/comparison/comparison.h"
#include "core/diagnosis/conventions.h"
#include "core/identification/identification.h"

#include <stop_token>
#include <vector>

namespace slidercrank
{

struct Interpretation {
    std::vector<ConventionFinding> conventions; ///< in the order in which they are to be applied

    // All these of the data as they read with the conventions.
    std::vector<Attribution> attribution; ///< as attribute(); empty where no channel differs from the mechanism
    Identification identification;
    std::vector<ChannelComparison> identified; ///< against the identified mechanism; empty where none was found
    Parameters rounded; ///< what to take over: the identified mechanism in round numbers, as inRoundNumbers()
};

Interpretation interpret(const ReferenceData &data, const Mechanism &mechanism, std::stop_token stop = {});

} // namespace slidercrank
