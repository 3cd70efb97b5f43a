// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnosis/diagnosis.h"

#include "core/diagnosis/explanation.h"
#include "core/identification/round_numbers.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

using Outcome = Identification::Outcome;

bool isAnyDifferent(const std::vector<ChannelComparison> &channels)
{
    return std::ranges::find(channels, Verdict::Differs, &ChannelComparison::verdict) != channels.end();
}

/// A length is not beyond a hundredth and a hundred times the others.
bool isSensible(const ParameterChange &change, Parameters parameters)
{
    constexpr double kBeyond = 100.0;
    valueOf(parameters, change.parameter) = change.value;
    const auto [shorter, longer] = std::minmax(parameters.a, parameters.b);
    return longer <= kBeyond * shorter && std::abs(parameters.c) <= kBeyond * longer;
}

std::optional<ParameterChange> changeFor(const ReferenceData &data, const Mechanism &mechanism,
                                         const std::stop_token &stop)
{
    constexpr double kNearlyAll = 0.99; // of the squares: what is left is a tenth of the error
    const std::vector<ParameterChange> changes = parameterChanges(data, mechanism, stop);
    const bool isChange = !changes.empty() && changes.front().explained >= kNearlyAll &&
                          isSensible(changes.front(), mechanism.parameters());
    return isChange ? std::optional(changes.front()) : std::nullopt;
}

} // namespace

Diagnosis diagnose(const ReferenceData &data, const Mechanism &mechanism, std::stop_token stop)
{
    Diagnosis result;
    result.conventions = findConventions(data, mechanism, stop);
    Mechanism model = mechanism;
    std::optional<ReferenceData> converted; // a file may be large: copied only where it reads otherwise
    for (const ConventionFinding &finding : result.conventions) {
        if (finding.convention.kind == Convention::Kind::Branch) {
            Parameters other = model.parameters();
            other.branch = otherThan(other.branch);
            model = Mechanism(other);
        } else {
            converted = applied(finding.convention, converted ? std::move(*converted) : data);
        }
    }
    const ReferenceData &reading = converted ? *converted : data;

    Identification &found = result.identification;
    found = identify(reading, model, stop);
    result.isOfMechanismAtHand = !isAnyDifferent(compareExactly(model, reading, stop).channels);
    if (found.outcome == Outcome::Identified) {
        result.identified = compareExactly(Mechanism(found.parameters), reading, stop).channels;
        result.rounded = inRoundNumbers(found, reading, result.identified);
        if (isAnyDifferent(result.identified)) {
            found.outcome = Outcome::Nearest;
        } else if (!result.isOfMechanismAtHand) {
            result.change = changeFor(reading, model, stop);
        }
    }
    if (stop.stop_requested()) {
        found.stopped = true;
        return result;
    }
    if (found.outcome != Outcome::Identified) {
        found.standardError.fill(kNone);
        found.identifiable.fill(false);
        found.alternatives.clear();
        result.rounded = found.parameters;
        if (!result.isOfMechanismAtHand) {
            result.conventions.clear();
        }
    }
    return result;
}

} // namespace slidercrank
