// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether what the program claims of a file of known origin is so.

#include "tests/support/claim_files.h"
#include "tests/support/program_claim.h"

#include <string>
#include <vector>

namespace slidercrank
{

struct ClaimJudgement {
    ClaimedOutcome outcome = ClaimedOutcome::None;
    bool right = false;     ///< identified, or ambiguous with the truth among what is listed
    bool fixes = false;     ///< the file fixes the mechanism
    std::string falseClaim; ///< why; empty: none
    std::string miss;       ///< of a file that fixes it
};

ClaimJudgement judged(const ClaimFile &file, const ReferenceData &data);

/// By how many of its standard errors each parameter is off, of the image of the truth that comes nearest; empty where
/// nothing is identified. What is not identifiable is left out.
std::vector<double> standardErrorsOff(const ClaimFile &file, const ProgramClaim &claim);

} // namespace slidercrank
