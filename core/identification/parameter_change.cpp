// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/parameter_change.h"

#include "core/identification/file_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace slidercrank
{

namespace
{

/// Σ r²/z², every column counting alike; infinite where the mechanism does not move as long as the data do.
double squaresOf(const FitProblem &problem, const Parameters &parameters)
{
    Fit at;
    at.parameters = parameters;
    FitResiduals left;
    if (!residualsOf(problem, at, left)) {
        return std::numeric_limits<double>::infinity();
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        for (const double residual : left.residuals[k]) {
            const double part = residual / problem.columns[k].spread;
            sum += std::isnan(part) ? 0.0 : part * part;
        }
    }
    return sum;
}

} // namespace

std::vector<ParameterChange> parameterChanges(const ReferenceData &data, const Mechanism &mechanism,
                                              const Parameters &found, std::stop_token stop)
{
    const Parameters &given = mechanism.parameters();
    const std::optional<FileSearch> search = searchIn(data, given);
    if (!search) {
        return {};
    }
    const SearchRows rows = wholeOf(data, *search, given);
    const FitProblem problem = problemOf(rows.all, asWritten(rows.all));
    const FitUnits &units = rows.all.units;
    // The crank's angle at the middle of the data depends on the speed: the parameters are changed as a person would.
    const double before = squaresOf(problem, units.toFit(given));
    std::vector<ParameterChange> changes;
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        const auto parameter = static_cast<Parameter>(i);
        Parameters trial = given;
        valueOf(trial, parameter) = valueOf(found, parameter);
        if (parameter == Parameter::Theta20) {
            trial.theta20 = given.theta20 + std::remainder(found.theta20 - given.theta20, 2.0 * std::numbers::pi);
        }
        if (stop.stop_requested()) {
            return {};
        }
        if (findFault(trial)) {
            continue;
        }
        const double least = squaresOf(problem, units.toFit(trial));
        const double explained = before > 0.0 && std::isfinite(before) && least < before ? 1.0 - least / before : 0.0;
        changes.push_back({parameter, valueOf(trial, parameter), explained});
    }
    std::ranges::stable_sort(changes, std::ranges::greater(), &ParameterChange::explained);
    return changes;
}

} // namespace slidercrank
