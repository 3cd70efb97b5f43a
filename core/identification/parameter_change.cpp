// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/parameter_change.h"

#include "core/identification/motion_fit.h"
#include "core/identification/motion_start.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace slidercrank
{

namespace
{

/// Rows that a search looks at, and rows of the fit that ends it.
constexpr std::size_t kSearchRows = 32;
constexpr std::size_t kFitRows = 2000;

constexpr int kMostIterations = 30;

/// Where to look for one parameter, ascending: everywhere that the motion may still resemble.
std::vector<double> valuesToTry(Parameter parameter, const Parameters &given, const Courses &courses)
{
    std::vector<double> values;
    switch (parameter) {
    case Parameter::A:
    case Parameter::B: {
        const double length = parameter == Parameter::A ? given.a : given.b;
        for (double factor = 0.1; factor < 10.0; factor *= 1.2) {
            values.push_back(factor * length);
        }
        break;
    }
    case Parameter::C: {
        // Farther out the slider cannot be reached.
        constexpr int kEachSide = 16;
        for (int i = -kEachSide; i <= kEachSide; ++i) {
            values.push_back((given.a + given.b) * i / kEachSide);
        }
        break;
    }
    case Parameter::Omega2:
        values = likelySpeeds(courses);
        for (std::size_t i = 0, count = values.size(); i < count; ++i) {
            values.push_back(-values[i]);
        }
        std::sort(values.begin(), values.end());
        break;
    case Parameter::Theta20:
        constexpr int kDirections = 24;
        for (int i = 0; i < kDirections; ++i) {
            values.push_back(given.theta20 + 2.0 * std::numbers::pi * i / kDirections - std::numbers::pi);
        }
        break;
    }
    return values;
}

/// Whether the mechanism has a motion wherever the data have one: no cause of them otherwise.
bool canMove(const Observations &observations, const Parameters &parameters)
{
    PlottedValues motion;
    return std::ranges::all_of(observations.time, [&](double t) { return plottedMotion(parameters, t, motion); });
}

} // namespace

std::vector<ParameterChange> parameterChanges(const ReferenceData &data, const Mechanism &mechanism,
                                              std::stop_token stop)
{
    const Supply supply = supplyOf(data);
    if (supply.rows.size() < 2) {
        return {};
    }
    const FitUnits units = unitsFor(data, supply, mechanism.a());
    const Parameters given = units.toFit(mechanism.parameters());
    const Courses courses = coursesOf(data, supply, units);
    const Observations few = observe(data, units, thinned(rowsBefore(supply.rows, courses.endRow), kSearchRows));
    const Observations all = observe(data, units, thinned(supply.rows, kFitRows));
    const double before = misfit(all, given);

    std::vector<ParameterChange> changes;
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        const auto parameter = static_cast<Parameter>(i);
        Parameters best = given;
        double least = misfit(few, given);
        for (const double value : valuesToTry(parameter, given, courses)) {
            Parameters trial = given;
            valueOf(trial, parameter) = value;
            const double distance = misfit(few, trial);
            if (distance < least && canMove(few, trial)) {
                least = distance;
                best = trial;
            }
        }
        FreeParameters isFree{};
        isFree[i] = true;
        best = fit(few, best, isFree, kMostIterations, stop).parameters;
        if (courses.endRow <= supply.rows.back()) {
            best = fitGrowing(data, units, supply, courses.endRow, best, isFree, stop).parameters;
        }
        best = fit(all, best, isFree, kMostIterations, stop).parameters;
        if (stop.stop_requested()) {
            return {};
        }
        if (!canMove(all, best)) {
            best = given;
        }
        const double after = std::min(misfit(all, best), before);
        const double explained = before > 0.0 ? 1.0 - (after / before) * (after / before) : 0.0;
        changes.push_back({parameter, valueOf(units.fromFit(best), parameter), explained});
    }
    std::ranges::stable_sort(changes, std::ranges::greater(), &ParameterChange::explained);
    return changes;
}

} // namespace slidercrank
