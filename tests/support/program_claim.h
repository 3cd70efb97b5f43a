// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Everything that the program says about a file, in one form. Only program_claim.cpp knows the types of the engine.

#include "core/comparison/comparison.h"
#include "core/mechanism/mechanism.h"
#include "tests/support/claim_file.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace slidercrank
{

enum class ClaimedOutcome { Identified, Ambiguous, Approximate, Insufficient, Nearest, None };
inline constexpr std::array<std::string_view, 6> kOutcomeNames{"identified",   "ambiguous", "approximate",
                                                               "insufficient", "nearest",   "none"};

struct ProgramClaim {
    ClaimedOutcome outcome = ClaimedOutcome::None;
    Parameters parameters;
    std::array<double, kParameterCount> standardError{};
    std::array<bool, kParameterCount> identifiable{};
    bool onlyRatios = false;
    std::vector<Parameters> images;       ///< that no column is said to exclude
    std::vector<Parameters> alternatives; ///< other mechanisms
    struct ClaimedFinding : Finding {
        double before = 0.0; ///< % of peak
        double after = 0.0;
    };
    std::vector<ClaimedFinding> findings;
    struct ChannelValue {
        Channel channel;
        double value = 0.0;
    };
    std::vector<ChannelValue> noise;   ///< rms
    std::vector<ChannelValue> leftOut; ///< columns that take no part in the fit, with their deviation, % of peak
    std::vector<std::size_t> excludedLines;
    Parameters rounded;
    std::optional<Parameter> change; ///< the one parameter that explains the difference from the given mechanism
    double changedValue = 0.0;
    std::optional<std::array<double, 2>> crankSpeeds; ///< rad/s, at start and end, of a crank that turns unevenly

    ReferenceData read;                        ///< the file as it reads with the findings
    std::vector<ChannelComparison> identified; ///< its columns against `parameters`
};

ProgramClaim claimAbout(const ReferenceData &data, const Mechanism &given);

} // namespace slidercrank
