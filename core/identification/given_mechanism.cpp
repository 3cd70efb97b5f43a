// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/given_mechanism.h"

#include "core/identification/round_values.h"
#include "core/identification/rounding_test.h"

#include "core/import/crank_angles.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

/// Parameters of an exact file, whose standard errors are tiny, may differ by this fraction of their size from those
/// that a person has typed with few digits. For angles, it is 0.1°.
constexpr double kTypedDifference = 2e-3;

/// Whether two mechanisms have the same lengths and speed, within three standard errors or 0.2 %.
bool areNear(const Parameters &found, const Parameters &given, const ParameterErrors &errors)
{
    return std::ranges::all_of(kAllParameters, [&](Parameter parameter) {
        const double error = errors[indexOf(parameter)];
        const double tolerance = std::max(kTypedDifference * parameterSize(parameter, given),
                                          std::isfinite(error) ? kStandardErrors * error : 0.0);
        return parameter == Parameter::Theta20 ||
               std::abs(valueOf(found, parameter) - valueOf(given, parameter)) <= tolerance;
    });
}

/// Appends a convention of all columns of the file for whose channel `concerns` returns true.
template <class Predicate>
void append(std::vector<ConventionFinding> &conventions, const ReferenceData &data, Kind kind, double amount,
            const Predicate &concerns)
{
    Convention &convention = conventions.emplace_back(ConventionFinding{{kind, {}, amount}}).convention;
    for (const ReferenceSeries &series : data.series) {
        if (concerns(series.channel)) {
            convention.channels.push_back(series.channel);
        }
    }
}

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
    std::erase_if(unknowns, [](Unknown unknown) { return unknown.kind <= Unknown::Kind::C; });
    return unknowns;
}

/// Changes of all columns of a file.
struct WholeFileChange {
    double lengthFactor = 1.0;
    double timeFactor = 1.0;
    bool isReversed = false; ///< angles are counted in the opposite direction
};

/// The change after which the mechanism found is nearest to the given one.
WholeFileChange findChangeTowards(const Parameters &given, const Parameters &found, const ReferenceData &data)
{
    const auto isLength = [](const ReferenceSeries &series) { return !isAngle(series.channel.coordinate); };
    const auto length = std::ranges::find_if(data.series, isLength);
    const double lengthUnit = length != data.series.end() ? length->rounding.unitFactor : 1.0;
    WholeFileChange change{.lengthFactor = nearestFactor(kLengthFactors, given.a / found.a, lengthUnit)};
    if (!data.crank) { // a table over the crank angle shows neither
        change.timeFactor = nearestFactor(kTimeFactors, found.omega2 / given.omega2, data.timeRounding.unitFactor);
        change.isReversed = found.omega2 * given.omega2 < 0.0;
    }
    return change;
}

/// Appends the conventions that, together, are a change of the whole file. `branch`: the assembly of the
/// mechanism found.
void appendConventions(std::vector<ConventionFinding> &conventions, const WholeFileChange &change,
                       const ReferenceData &data, Branch branch)
{
    if (change.lengthFactor != 1.0) {
        append(conventions, data, Kind::LengthUnit, change.lengthFactor,
               [](Channel channel) { return !isAngle(channel.coordinate); });
    }
    if (change.timeFactor != 1.0) {
        append(conventions, data, Kind::TimeUnit, change.timeFactor,
               [](Channel channel) { return channel.order != Order::Position; });
    }
    if (change.isReversed) {
        append(conventions, data, Kind::Sign, -1.0, [](Channel channel) { return isAngle(channel.coordinate); });
        const Channel coupler{Theta3, Order::Position}; // of the crossed assembly, it is about half a turn
        if (branch == Branch::Crossed && data.find(coupler)) {
            append(conventions, data, Kind::WholeTurns, kTurn * kDegreesPerRadian,
                   [&](Channel channel) { return channel == coupler; });
        }
    }
}

/// Adds a change of the whole file to a reading: its conventions, and the mechanism that is found after it.
WholeFileReading addChange(WholeFileReading reading, const WholeFileChange &change, const ReferenceData &data)
{
    Parameters &found = reading.parameters;
    for (const Parameter length : kLengths) {
        valueOf(found, length) *= change.lengthFactor;
        reading.standardError[indexOf(length)] *= change.lengthFactor;
    }
    const double sense = change.isReversed ? -1.0 : 1.0;
    found.c *= sense;
    found.omega2 *= sense / change.timeFactor;
    found.theta20 *= sense;
    reading.standardError[indexOf(Parameter::Omega2)] /= change.timeFactor;
    appendConventions(reading.conventions, change, data, found.branch);
    return reading;
}

/// If the crank is not at the given angle at t = 0, appends a late start, and turns the mechanism found accordingly.
void appendLateStart(WholeFileReading &reading, const Parameters &given)
{
    Parameters &p = reading.parameters;
    const double angle = std::remainder(p.theta20 - given.theta20, kTurn);
    const double error = reading.standardError[indexOf(Parameter::Theta20)];
    const double tolerance =
        std::isfinite(error) ? std::max(kTypedDifference, kStandardErrors * error) : kTypedDifference;
    if (std::abs(angle) > tolerance) {
        const double late =
            roundToFewestDigits(angle / given.omega2, error / std::abs(given.omega2), std::array{1.0}).value;
        reading.conventions.push_back({{Kind::TimeShift, {}, late}});
        p.theta20 = std::remainder(p.theta20 - late * p.omega2, kTurn);
    }
}

/// The round number near the value that `fit` has found for a length, if it explains the file as well as `best` does;
/// otherwise that value (mm).
double roundIfExplainedAsWell(const Observations &observations, const Fit &fit, Parameter length, const Fit &best,
                              double lengthUnit)
{
    const double value = valueOf(fit.model.mechanism, length);
    const Index position = fit.indexOf(toUnknown(length));
    const double error = std::sqrt(dependence(fit) * computeCovariance(fit)(position, position));
    Model model = fit.model;
    valueOf(model.mechanism, length) = roundLength(value, error, lengthUnit).value;
    const Fit rounded = fitModel(observations, model, fit.columns, unknownsExceptLengths(fit));
    return explainsAsWell(observations, rounded, best) ? valueOf(model.mechanism, length) : value;
}

} // namespace

Fit fitWithGivenLengths(const Observations &observations, const Fit &best, const Parameters &given)
{
    const Model start = modelWithGivenLengths(best, given);
    return fitModel(observations, start, best.columns, unknownsExceptLengths(best));
}

bool explainsAsWell(const Observations &observations, const Fit &fit, const Fit &best)
{
    return isExact(observations, fit) || fit.misfit - best.misfit < kSameMisfit * dependence(best);
}

std::optional<LengthChange> findLengthChange(const Observations &observations, const Fit &best, const Parameters &given,
                                             double lengthUnit)
{
    std::vector<LengthChange> changes;
    for (const Parameter length : kLengths) {
        Model changed = modelWithGivenLengths(best, given);
        valueOf(changed.mechanism, length) = valueOf(best.model.mechanism, length);
        Unknowns unknowns = unknownsExceptLengths(best);
        unknowns.push_back(toUnknown(length));
        const Fit fit = fitModel(observations, changed, best.columns, unknowns);
        if (explainsAsWell(observations, fit, best)) {
            changes.push_back({length, roundIfExplainedAsWell(observations, fit, length, best, lengthUnit)});
        }
    }
    return changes.size() == 1 ? std::optional(changes[0]) : std::nullopt;
}

WholeFileReading findWholeFileReading(const ReferenceData &data, const Parameters &found,
                                      const ParameterErrors &standardError, const Parameters &given)
{
    // Several changes lead to the given mechanism by chance more often than one. A file with θ2 shows how the crank
    // turns and where it starts; it needs no second change.
    const std::size_t maxConventions = data.find(kCrankAngle) ? 1 : 2;
    const WholeFileReading unchanged{.parameters = found, .standardError = standardError};
    WholeFileReading reading = addChange(unchanged, findChangeTowards(given, found, data), data);
    if (!areNear(reading.parameters, given, reading.standardError)) {
        return unchanged;
    }
    if (found.branch != given.branch) {
        reading.conventions.push_back({{Kind::Branch, {}, 1.0}});
    }
    if (!data.crank) {
        appendLateStart(reading, given);
    }
    return reading.conventions.size() <= maxConventions ? reading : unchanged;
}

} // namespace slidercrank
