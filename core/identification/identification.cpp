// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/identification/crank_speed.h"
#include "core/identification/decision.h"
#include "core/identification/file_search.h"
#include "core/identification/motion_start.h"

#include <algorithm>
#include <limits>

namespace slidercrank
{

void Identification::claimNothing()
{
    standardError.fill(std::numeric_limits<double>::quiet_NaN());
    identifiable.fill(false);
    alternatives.clear();
    noise.clear();
    leftOut.clear();
    excludedRows.clear();
}

void Identification::keepToMechanisms(const Parameters &atHand)
{
    const auto isNone = [](const Alternative &alternative) { return findFault(alternative.parameters).has_value(); };
    if (findFault(parameters) || std::ranges::any_of(alternatives, isNone)) {
        outcome = Outcome::None;
        parameters = atHand;
        claimNothing();
    }
}

Identification identify(const ReferenceData &data, const Mechanism &start, std::stop_token stop)
{
    const Parameters &given = start.parameters();
    Identification nothing;
    nothing.parameters = given;
    nothing.claimNothing();
    nothing.outcome = Identification::Outcome::Insufficient;
    nothing.lack = Identification::Lack::FewInstants;
    const std::optional<FileSearch> search = searchIn(data, given);
    if (!search) {
        return nothing;
    }
    if (const auto lack = lackOf(search->window.all)) {
        nothing.lack = *lack;
        return nothing;
    }
    const FileReading plain = asWritten(search->window.all);
    const FitProblem problem = problemOf(search->window.all, plain);
    std::vector<Parameters> starts = startsOf(problem, speedsOf(problem, stop), search->window.given.a, stop);
    starts.push_back(search->window.given);
    // Another origin may lead there, but the file is read as it says.
    std::vector<Candidate> candidates = plainCandidates(search->window, starts, stop);
    std::erase_if(candidates, [&](const Candidate &candidate) { return candidate.reading != plain; });
    const SearchRows whole = wholeOf(data, *search, given);
    for (Candidate &candidate : candidates) {
        candidate = grown(data, *search, whole, candidate, stop);
    }
    std::ranges::stable_sort(candidates, isBetter);
    Identification found = decisionOn(whole, candidates, given, stop);
    found.keepToMechanisms(given);
    return found;
}

} // namespace slidercrank
