// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnosis/interpretation.h"

#include "core/diagnosis/explanation.h"
#include "core/identification/round_numbers.h"

#include <algorithm>
#include <optional>

namespace slidercrank
{

namespace
{

bool isDifferent(const ReferenceData &data, const Mechanism &mechanism, std::stop_token stop)
{
    const std::vector<ChannelComparison> channels = compareExactly(mechanism, data, stop).channels;
    return std::ranges::find(channels, Verdict::Differs, &ChannelComparison::verdict) != channels.end();
}

} // namespace

Interpretation interpret(const ReferenceData &data, const Mechanism &mechanism, std::stop_token stop)
{
    Interpretation result;
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

    result.identification = identify(reading, model, stop);
    if (stop.stop_requested()) {
        result.identification.status = Identification::Status::Stopped;
        return result;
    }
    if (isDifferent(reading, model, stop)) {
        result.attribution = attribute(reading, model, stop);
    }
    if (result.identification.status == Identification::Status::Found) {
        const Mechanism found(result.identification.parameters);
        result.identified = compareExactly(found, reading, stop).channels;
        result.rounded = inRoundNumbers(result.identification, reading, result.identified);
    }
    return result;
}

} // namespace slidercrank
