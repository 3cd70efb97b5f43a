// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/length_change.h"

#include "core/identification/residual_test.h"
#include "core/identification/round_number.h"

#include <cmath>
#include <vector>

namespace slidercrank
{

namespace
{

/// The model of `best` with the lengths of the given mechanism.
Model modelWithGivenLengths(const Fit &best, const Parameters &given)
{
    Model model = best.model;
    for (const Parameter length : kLengths) {
        valueOf(model.mechanism, length) = valueOf(given, length);
    }
    return model;
}

/// The unknowns of a fit, except for the lengths.
Unknowns unknownsExceptLengths(const Fit &fit)
{
    Unknowns unknowns = fit.unknowns;
    for (const Parameter length : kLengths) {
        std::erase(unknowns, length);
    }
    return unknowns;
}

/// The round number near the value that `fit` has found for a length, if it explains the file as well as `best` does;
/// otherwise that value (mm).
double roundIfExplainedAsWell(const Observations &observations, const Fit &fit, Parameter length, const Fit &best)
{
    const double value = valueOf(fit.model.mechanism, length);
    const double error = std::sqrt(dependence(fit)) * standardErrorOrZero(fit, length);
    Model model = fit.model;
    valueOf(model.mechanism, length) = roundLength(value, error, observations.lengthUnit).value;
    const Fit rounded = fitModel(observations, model, fit.columns, unknownsExceptLengths(fit));
    return explainsAsWell(observations, rounded, best) ? valueOf(model.mechanism, length) : value;
}

} // namespace

Fit fitWithGivenLengths(const Observations &observations, const Fit &best, const Parameters &given)
{
    const Model start = modelWithGivenLengths(best, given);
    return fitModel(observations, start, best.columns, unknownsExceptLengths(best));
}

std::optional<LengthChange> findLengthChange(const Observations &observations, const Fit &best, const Parameters &given)
{
    std::vector<LengthChange> changes;
    for (const Parameter length : kLengths) {
        Model changed = modelWithGivenLengths(best, given);
        valueOf(changed.mechanism, length) = valueOf(best.model.mechanism, length);
        Unknowns unknowns = unknownsExceptLengths(best);
        unknowns.push_back(length);
        const Fit fit = fitModel(observations, changed, best.columns, unknowns);
        if (explainsAsWell(observations, fit, best)) {
            changes.push_back({length, roundIfExplainedAsWell(observations, fit, length, best)});
        }
    }
    return changes.size() == 1 ? std::optional(changes[0]) : std::nullopt;
}

} // namespace slidercrank
