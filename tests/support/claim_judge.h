// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Judges whether the program's claims about a file of known origin are true.

#include "tests/support/claim_file.h"
#include "tests/support/program_claim.h"

#include <string>
#include <vector>

namespace slidercrank
{

struct ClaimJudgement {
    ClaimedOutcome outcome = ClaimedOutcome::None;
    bool isRight = false;      ///< the truth is the identified (or accepted approximate) mechanism or is listed
    bool isDetermined = false; ///< whether the file determines its mechanism
    std::string falseClaim{};  ///< why a claim is false; empty if none is
    std::string miss{};        ///< what the program missed although the file determines its mechanism
};

ClaimJudgement judgeClaim(const ClaimFile &file, const ReferenceData &data, const ProgramClaim &claim);

/// Returns the distance of each parameter from the nearest image of the truth, in standard errors. Empty unless
/// identified.
std::vector<double> errorsInStandardErrors(const ClaimFile &file, const ProgramClaim &claim);

} // namespace slidercrank
