// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program_claim.h"

#include "core/identification/diagnosis.h"

#include <string_view>
#include <utility>

namespace slidercrank
{

namespace
{

std::string_view wordOf(Convention::Kind kind)
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
    default: return "axis";
    }
}

} // namespace

ProgramClaim claimOf(const ReferenceData &data, const Mechanism &atHand)
{
    ProgramClaim claim;
    const Diagnosis said = diagnose(data, atHand);
    switch (said.identification.outcome) {
    case Identification::Outcome::Identified: claim.outcome = ClaimedOutcome::Identified; break;
    case Identification::Outcome::Ambiguous: claim.outcome = ClaimedOutcome::Ambiguous; break;
    case Identification::Outcome::Approximate: claim.outcome = ClaimedOutcome::Approximate; break;
    case Identification::Outcome::Insufficient: claim.outcome = ClaimedOutcome::Insufficient; break;
    case Identification::Outcome::Nearest: claim.outcome = ClaimedOutcome::Nearest; break;
    case Identification::Outcome::None: claim.outcome = ClaimedOutcome::None; break;
    }
    using Why = Identification::Alternative::Why;
    for (const auto &[why, parameters] : said.identification.alternatives) {
        const bool isImage = why != Why::Alias && why != Why::AnotherMechanism;
        (isImage ? claim.images : claim.alternatives).push_back(parameters);
    }
    if (said.change) {
        claim.change = said.change->parameter;
        claim.changed = said.change->value;
    }
    if (said.unevenCrank) {
        claim.crankSpeeds = {said.unevenCrank->atStart, said.unevenCrank->atEnd};
    }
    claim.parameters = said.identification.parameters;
    claim.standardError = said.identification.standardError;
    claim.identifiable = said.identification.identifiable;
    claim.onlyRatios = said.identification.onlyRatios;
    claim.rounded = said.rounded;
    claim.identified = said.identified;
    claim.read = data;
    for (const ConventionFinding &finding : said.conventions) {
        const Convention &convention = finding.convention;
        claim.findings.push_back({wordOf(convention.kind), convention.channels, convention.amount});
        claim.read = applied(convention, std::move(claim.read));
    }
    return claim;
}

} // namespace slidercrank
