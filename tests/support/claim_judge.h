// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Judges whether the program's claims about a file of known origin are true.

#include "core/identification/diagnosis.h"
#include "core/import/reference_data.h"
#include "tests/support/claim_file.h"

#include <string>
#include <vector>

namespace slidercrank
{

/// What the program claims about a file.
struct Claim {
    Claim(const ClaimFile &claimFile, const ReferenceData &referenceData);

    const ClaimFile &file;
    const ReferenceData &data;
    Diagnosis diagnosis;
    const Identification &found = diagnosis.identification;
    ReferenceData read; ///< the data with the conventions that the program found

    bool isIdentified() const;
    bool isApproximate() const { return found.outcome == Identification::Outcome::Approximate; }
    bool isNearest() const { return found.outcome == Identification::Outcome::Nearest; }
    bool has(Convention::Kind kind, Channel channel) const; ///< whether a convention concerns the column
    bool isLeftOut(Channel channel) const;
};

/// Error of a claimed parameter.
struct ParameterError {
    double difference;
    double standardError; ///< 0 if none is claimed
    double size;          ///< of the parameter
};

/// Returns the errors of the parameters that the claim identifies.
std::vector<ParameterError> parameterErrors(const Claim &claim, const Parameters &parameters, const Parameters &truth);

/// Describes a false statement about deviations, noise, omitted columns or excluded rows. Empty if all are true.
std::string falseDeviation(const Claim &claim);

struct Judgement {
    Identification::Outcome outcome = Identification::Outcome::None;
    std::string falseClaim{}; ///< why a claim is false; empty if none is
    bool isDetermined = false;
    bool isMissed = false; ///< the file determines its mechanism, which the program did not find
};

Judgement judge(const Claim &claim);

} // namespace slidercrank
