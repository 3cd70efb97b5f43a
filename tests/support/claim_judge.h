// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Judges whether the program's claims about a file of known origin are true.

#include "core/identification/diagnosis.h"
#include "core/import/reference_data.h"
#include "tests/support/claim_file.h"

#include <array>
#include <string>
#include <vector>

namespace slidercrank
{

/// What the program claims about a file.
struct Claim {
    Claim(const ClaimFile &claimFile, const ReferenceData &data);

    const ClaimFile &file;
    Diagnosis diagnosis;
    const Identification &found = diagnosis.identification;
    ReferenceData read; ///< the data with the conventions that the program found

    bool isIdentified() const; ///< as one mechanism or one of several
    bool isUsed(Channel channel) const;
};

/// Error of a claimed parameter.
struct ParameterError {
    double difference;
    double standardError; ///< 0 if none is claimed
    double size;          ///< of the parameter
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
bool determinesItsMechanism(const ClaimFile &file);

/// Describes a false statement about deviations, noise, omitted columns or excluded rows. Empty if all are true.
std::string falseDeviation(const Claim &claim);

/// Returns whether the columns, as the claim interprets them, show no deviation from a mechanism. `isStrict`: none
/// beyond their true noise and rounding; otherwise, none that is large and not explained by the noise that is claimed.
bool explains(const Claim &claim, const Parameters &parameters, bool isStrict);

struct Judgement {
    Identification::Outcome outcome = Identification::Outcome::None;
    std::string falseClaim{}; ///< why a claim is false; empty if none is
    bool isDetermined = false;
    bool isMissed = false; ///< the file determines its mechanism, which the program did not find
};

Judgement judge(const Claim &claim);

} // namespace slidercrank
