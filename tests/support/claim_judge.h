// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the program claims of a file of known origin, and whether that is so.

#include "core/comparison/comparison.h"
#include "core/mechanism/mechanism.h"
#include "tests/support/claim_files.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

enum class ClaimedOutcome { Identified, Ambiguous, Insufficient, Nearest, None };

/// All that the program says of a file.
struct ProgramClaim {
    ClaimedOutcome outcome = ClaimedOutcome::None;
    Parameters parameters;
    std::array<double, kParameterCount> standardError{};
    std::array<bool, kParameterCount> identifiable{};
    bool onlyRatios = false;
    std::vector<Parameters> images;       ///< that no column is said to exclude
    std::vector<Parameters> alternatives; ///< other mechanisms
    std::vector<ExpectedFinding> findings;
    Parameters rounded;
    std::optional<Parameter> change;
    double changed = 0.0; ///< its value
    bool unevenCrank = false;

    /// The file as it reads with the findings, and its verdicts against `parameters`.
    ReferenceData read;
    std::vector<ChannelComparison> identified;
};

ProgramClaim claimOf(const ReferenceData &data, const Mechanism &atHand);

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
