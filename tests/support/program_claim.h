// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All that the program says of a file, in one form.

#include "core/comparison/comparison.h"
#include "core/mechanism/mechanism.h"
#include "tests/support/claim_files.h"

#include <array>
#include <optional>
#include <vector>

namespace slidercrank
{

enum class ClaimedOutcome { Identified, Ambiguous, Insufficient, Nearest, None, Approximate };

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
    double changed = 0.0;                             ///< its value
    std::optional<std::array<double, 2>> crankSpeeds; ///< rad/s, at start and end, of a crank that turns unevenly

    /// The file as it reads with the findings, and its verdicts against `parameters`.
    ReferenceData read;
    std::vector<ChannelComparison> identified;
};

ProgramClaim claimOf(const ReferenceData &data, const Mechanism &atHand);

} // namespace slidercrank
