// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Judges whether the program's claims about a table of known origin are true.

#include "core/identification/identification.h"
#include "core/import/reference_data.h"
#include "tests/support/claim_table.h"

#include <array>
#include <string>
#include <vector>

namespace slidercrank
{

/// What the program claims about a table.
struct Claim {
    Claim(const ClaimTable &claimTable, const ReferenceData &data);

    const ClaimTable &table;
    Identification found;
    ReferenceData read; ///< the data after the conventions that the program found are applied

    bool isUsed(Channel channel) const;
};

/// Error of a claimed parameter.
struct ParameterError {
    double difference;    ///< claimed - true; mm, rad/s or rad
    double standardError; ///< 0 if none is claimed
    double size;          ///< the parameter's entry in parameterSizes()
};

/// Returns the errors of the parameters that the claim identifies.
std::vector<ParameterError> parameterErrors(const Claim &claim, const Parameters &parameters, const Parameters &truth);

/// Returns the sizes to which the errors of the parameters are relative: a, b, max(|c|, a) for c, |ω2|, and 1 rad for
/// θ20.
std::array<double, kParameterCount> parameterSizes(const Parameters &parameters);

/// Returns whether a fit can use a column with this channel.
bool canBeFitted(Channel channel);

/// Returns whether a table determines its mechanism: the rows per turn and the evidence are sufficient, systematic
/// deviations are below half a percent of the range, and in a least-squares fit that is linearized at the truth, every
/// standard error is below 1 % and the linearization is valid.
bool determinesItsMechanism(const ClaimTable &table);

/// Describes the first false statement about excluded rows, residuals or alternative mechanisms. Empty if all are true.
std::string falseResidual(const Claim &claim);

/// Returns whether each used column, after the claimed conventions are applied, deviates from the mechanism (rms) by at
/// most 1.5 times its rounding and true noise.
bool explainsExactly(const Claim &claim, const Parameters &parameters);

struct Judgement {
    Identification::Outcome outcome = Identification::Outcome::None;
    std::string falseClaim{}; ///< why a claim is false; empty if none is
    bool isDetermined = false;
    bool isMissed = false; ///< a determined mechanism or uneven speed was not found
};

Judgement judge(const Claim &claim);

} // namespace slidercrank
