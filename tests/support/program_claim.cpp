// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program_claim.h"

#include "core/identification/diagnosis.h"

#include <utility>

namespace slidercrank
{

namespace
{

ClaimedOutcome claimedOutcome(Identification::Outcome outcome)
{
    switch (outcome) {
    case Identification::Outcome::Identified: return ClaimedOutcome::Identified;
    case Identification::Outcome::Ambiguous: return ClaimedOutcome::Ambiguous;
    case Identification::Outcome::Approximate: return ClaimedOutcome::Approximate;
    case Identification::Outcome::Insufficient: return ClaimedOutcome::Insufficient;
    case Identification::Outcome::Nearest: return ClaimedOutcome::Nearest;
    case Identification::Outcome::None: break;
    }
    return ClaimedOutcome::None;
}

std::string_view nameOf(Convention::Kind kind)
{
    switch (kind) {
    case Convention::Kind::ZeroPoint: return "zero-point";
    case Convention::Kind::AngleUnit: return "angle-unit";
    case Convention::Kind::LengthUnit: return "length-unit";
    case Convention::Kind::TimeUnit: return "time-unit";
    case Convention::Kind::Sign: return "sign";
    case Convention::Kind::HalfTurn: return "half-turn";
    case Convention::Kind::WholeTurns: return "whole-turns";
    case Convention::Kind::SwappedColumns: return "swapped-columns";
    case Convention::Kind::Branch: return "branch";
    case Convention::Kind::TimeShift: return "time-shift";
    case Convention::Kind::NotDerivative: return "not-derivative";
    case Convention::Kind::Axis: break;
    }
    return "axis";
}

} // namespace

ProgramClaim claimAbout(const ReferenceData &data, const Mechanism &given)
{
    const Diagnosis diagnosis = diagnose(data, given);
    const Identification &identification = diagnosis.identification;
    ProgramClaim claim;
    claim.outcome = claimedOutcome(identification.outcome);
    claim.parameters = identification.parameters;
    claim.standardError = identification.standardError;
    claim.identifiable = identification.identifiable;
    claim.onlyRatios = identification.onlyRatios;
    using Why = Identification::Alternative::Why;
    for (const auto &[why, parameters] : identification.alternatives) {
        const bool isImage = why != Why::Alias && why != Why::AnotherMechanism;
        (isImage ? claim.images : claim.alternatives).push_back(parameters);
    }
    for (const auto &[channel, rms] : identification.noise) {
        claim.noise.push_back({channel, rms});
    }
    for (const auto &[channel, percentOfPeak] : identification.leftOut) {
        claim.leftOut.push_back({channel, percentOfPeak});
    }
    claim.excludedLines = identification.excludedRows;
    claim.rounded = diagnosis.rounded;
    if (diagnosis.change) {
        claim.change = diagnosis.change->parameter;
        claim.changedValue = diagnosis.change->value;
    }
    if (diagnosis.unevenCrank) {
        claim.crankSpeeds = {diagnosis.unevenCrank->atStart, diagnosis.unevenCrank->atEnd};
    }
    claim.identified = diagnosis.identified;
    claim.read = data;
    for (const ConventionFinding &finding : diagnosis.conventions) {
        const Convention &convention = finding.convention;
        claim.findings.push_back(
            {{nameOf(convention.kind), convention.channels, convention.amount}, finding.before, finding.after});
        claim.read = applied(convention, std::move(claim.read));
    }
    return claim;
}

} // namespace slidercrank
