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
    ReferenceData read; ///< the data with the conventions that the program found

    bool isUsed(Channel channel) const;
};

/// Error of a claimed parameter.
struct ParameterError {
    double difference;
    double standardError; ///< 0 if none is claimed
    double size;          ///< the parameter's entry in parameterSizes()
};

/// Returns the errors of the parameters that the claim identifies.
std::vector<ParameterError> parameterErrors(const Claim &claim, const Parameters &parameters, const Parameters &truth);

/// Returns the size of each parameter: a, b, ω2, one radian for θ20, and max(|c|, a) for c.
std::array<double, kParameterCount> parameterSizes(const Parameters &parameters);

/// Returns whether a fit can use a column.
bool canBeFitted(Channel channel);

/// Returns whether every standard error of a least-squares fit, linearized at the truth, is below 1 %, the
/// linearization is valid, evidence and rows per turn are sufficient, and systematic deviations are below half a
/// percent of the range.
bool determinesItsMechanism(const ClaimTable &table);

/// Describes a false statement about residuals, or mechanisms that do not explain the table, or excluded rows that are
/// right. Empty if all are true.
std::string falseResidual(const Claim &claim);

/// Returns whether the used columns, as the claim reads them, deviate from the mechanism by no more than rounding and
/// their true noise.
bool explainsExactly(const Claim &claim, const Parameters &parameters);

struct Judgement {
    Identification::Outcome outcome = Identification::Outcome::None;
    std::string falseClaim{}; ///< why a claim is false; empty if none is
    bool isDetermined = false;
    bool isMissed = false; ///< the table determines its mechanism, which the program did not find
};

Judgement judge(const Claim &claim);

} // namespace slidercrank
