// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/diagnosis.h"

#include "core/explanation.h"
#include "core/trajectory.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

/// What the data cannot fix is as in the start: with another start it is another identification.
bool dependsOnStart(const Identification &identification)
{
    return identification.status != Identification::Status::Found ||
           std::ranges::find(identification.identifiable, false) != identification.identifiable.end();
}

std::vector<ChannelComparison> compareWith(const Mechanism &mechanism, const ReferenceData &data, std::stop_token stop)
{
    SolverSettings exact;
    exact.method = Method::ClosedForm;
    const Trajectory motion = sample(mechanism, data.time, channelsOf(data), exact, stop);
    return motion.complete ? compare(mechanism, motion, data) : std::vector<ChannelComparison>();
}

} // namespace

std::shared_ptr<const Diagnosis> diagnose(const std::shared_ptr<const Reference> &reference, const Mechanism &mechanism,
                                          bool agrees, const std::shared_ptr<const Diagnosis> &known,
                                          std::stop_token stop)
{
    const ReferenceData &data = reference->data;
    auto diagnosis = std::make_shared<Diagnosis>();
    diagnosis->reference = reference;
    diagnosis->parameters = mechanism.parameters();
    if (known && known->reference == reference && !dependsOnStart(known->identification)) {
        diagnosis->identification = known->identification;
        diagnosis->identified = known->identified;
    } else {
        diagnosis->identification = identify(data, mechanism, stop);
        if (diagnosis->identification.status == Identification::Status::Found) {
            diagnosis->identified = compareWith(Mechanism(diagnosis->identification.parameters), data, stop);
        }
    }
    if (!agrees) {
        diagnosis->conventions = findConventions(data, mechanism, stop);
        diagnosis->attribution = attribute(data, mechanism, stop);
    }
    if (stop.stop_requested()) {
        return nullptr;
    }
    return diagnosis;
}

} // namespace slidercrank
