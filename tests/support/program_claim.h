// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Everything that the program claims about a file, in one struct. Only program_claim.cpp depends on the identification.

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
    std::vector<Parameters> images;       ///< mirror images that no column excludes, according to the program
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
    std::vector<ChannelValue> leftOut; ///< columns omitted from the fit, with their deviation in % of peak
    std::vector<std::size_t> excludedLines;
    Parameters rounded;
    std::optional<Parameter> change; ///< the single parameter that explains the difference from `given`
    double changedValue = 0.0;
    std::optional<std::array<double, 2>> crankSpeeds; ///< rad/s at start and end, for a crank that turns unevenly

    ReferenceData read;                        ///< the file after the findings are applied
    std::vector<ChannelComparison> identified; ///< comparison of its columns with `parameters`
};

/// Identifies the mechanism of the data and returns what the program claims. `given` is the mechanism passed to it.
ProgramClaim claimAbout(const ReferenceData &data, const Mechanism &given);

} // namespace slidercrank
