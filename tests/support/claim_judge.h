// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether what the program claims about a file of known origin is true.

#include "tests/support/claim_file.h"
#include "tests/support/program_claim.h"

#include <string>
#include <vector>

namespace slidercrank
{

struct ClaimJudgement {
    ClaimedOutcome outcome = ClaimedOutcome::None;
    bool isRight = false; ///< identified (or approximate, where that is as good), or the truth is among those listed
    bool isDetermined = false; ///< the file determines its mechanism
    std::string falseClaim{};  ///< why; empty: none
    std::string miss{};        ///< what was missed in a file that determines its mechanism
};

ClaimJudgement judgeClaim(const ClaimFile &file, const ReferenceData &data, const ProgramClaim &claim);

/// How many of its standard errors each parameter is away from the nearest image of the truth; empty unless identified.
std::vector<double> errorsInStandardErrors(const ClaimFile &file, const ProgramClaim &claim);

} // namespace slidercrank
