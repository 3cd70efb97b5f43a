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
constexpr std::array kLengths{Parameter::A, Parameter::B, Parameter::C};

/// Whether two mechanisms have the same lengths and speed, within three standard errors or 0.2 %.
bool areNear(const Parameters &found, const Parameters &given, const ParameterErrors &errors)
{
    constexpr double kRelativeTolerance = 2e-3;
    return std::ranges::all_of(kAllParameters, [&](Parameter parameter) {
        const bool isLength = std::ranges::find(kLengths, parameter) != kLengths.end();
        const double size = isLength ? characteristicLength(given) : std::abs(given.omega2);
        const double error = errors[indexOf(parameter)];
        const double tolerance =
            std::max(kRelativeTolerance * size, std::isfinite(error) ? kStandardErrors * error : 0.0);
        return parameter == Parameter::Theta20 ||
               std::abs(valueOf(found, parameter) - valueOf(given, parameter)) <= tolerance;
    });
}

/// Appends a convention of all columns that it changes.
template <class Predicate>
void append(std::vector<ConventionFinding> &conventions, const ReferenceData &data, Kind kind, double amount,
            const Predicate &concerns)
{
    ConventionFinding &convention = conventions.emplace_back(ConventionFinding{{kind, {}, amount}});
    for (const ReferenceSeries &series : data.series) {
        if (concerns(series.channel)) {
            convention.channels.push_back(series.channel);
        }
    }
}

} // namespace

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

/// The unknowns of `best` without the lengths.
Unknowns withoutLengths(const Fit &best)
{
    Unknowns unknowns = best.unknowns;
    std::erase_if(unknowns, [](Unknown unknown) { return unknown.kind <= Unknown::Kind::C; });
    return unknowns;
}

} // namespace

Fit withGivenLengths(const Observations &observations, const Fit &best, const Parameters &given)
{
    return refined(observations, modelWithGivenLengths(best, given), best.columns, withoutLengths(best));
}

bool explainsAsWell(const Observations &observations, const Fit &fit, const Fit &best)
{
    return isExact(observations, fit) || fit.misfit - best.misfit < kSameMisfit * dependence(best);
}

std::optional<LengthChange> findLengthChange(const Observations &observations, const Fit &best, const Parameters &given)
{
    std::vector<LengthChange> changes;
    for (const Parameter length : kLengths) {
        Model changed = modelWithGivenLengths(best, given);
        valueOf(changed.mechanism, length) = valueOf(best.model.mechanism, length);
        Unknowns unknowns = withoutLengths(best);
        unknowns.push_back({static_cast<Unknown::Kind>(indexOf(length))});
        const Fit fit = refined(observations, changed, best.columns, unknowns);
        if (explainsAsWell(observations, fit, best)) {
            changes.push_back({length, valueOf(fit.model.mechanism, length)});
        }
    }
    return changes.size() == 1 ? std::optional(changes[0]) : std::nullopt;
}

WholeFileReading readLikeGiven(const ReferenceData &data, const Parameters &found, const ParameterErrors &standardError,
                               const Parameters &given)
{
    // θ2 shows the sense of rotation and the start, so that a wrong one of both would be a strange coincidence.
    const std::size_t mostConventions = data.find(kCrankAngle) ? 1 : 2;
    const auto isLength = [](Channel channel) { return !isAngle(channel.coordinate); };
    const auto isOfAngle = [](Channel channel) { return isAngle(channel.coordinate); };
    const auto isDerivative = [](Channel channel) { return channel.order != Order::Position; };
    const auto none = [](Channel) { return false; };
    const auto length = std::ranges::find_if(data.series, isLength, &ReferenceSeries::channel);
    const double lengthUnit = length != data.series.end() ? length->rounding.unitFactor : 1.0;
    const double lengthFactor = nearestFactor(kLengthFactors, given.a / found.a, lengthUnit);
    const double timeFactor =
        data.crank ? 1.0 : nearestFactor(kTimeFactors, found.omega2 / given.omega2, data.timeRounding.unitFactor);
    const bool isReversed = !data.crank && found.omega2 * given.omega2 < 0.0;
    const double sense = isReversed ? -1.0 : 1.0;
    WholeFileReading result{.parameters = found, .standardError = standardError};
    Parameters &p = result.parameters;
    ParameterErrors &errors = result.standardError;
    for (const Parameter parameter : kLengths) {
        valueOf(p, parameter) *= lengthFactor;
        errors[indexOf(parameter)] *= lengthFactor;
    }
    p.c *= sense;
    p.omega2 *= sense / timeFactor;
    p.theta20 *= sense;
    errors[indexOf(Parameter::Omega2)] /= timeFactor;
    if (!areNear(p, given, errors)) {
        return {{}, found, standardError};
    }
    std::vector<ConventionFinding> &conventions = result.conventions;
    if (lengthFactor != 1.0) {
        append(conventions, data, Kind::LengthUnit, lengthFactor, isLength);
    }
    if (timeFactor != 1.0) {
        append(conventions, data, Kind::TimeUnit, timeFactor, isDerivative);
    }
    if (isReversed) {
        append(conventions, data, Kind::Sign, -1.0, isOfAngle);
        const Channel coupler{Theta3, Order::Position}; // on the crossed branch, it is about half a turn
        if (found.branch == Branch::Crossed && data.find(coupler)) {
            append(conventions, data, Kind::WholeTurns, kTurn * kDegreesPerRadian,
                   [&](Channel channel) { return channel == coupler; });
        }
    }
    if (p.branch != given.branch) {
        append(conventions, data, Kind::Branch, 1.0, none);
    }
    constexpr double kSameAngle = 2e-3; // rad
    const double angle = std::remainder(p.theta20 - given.theta20, kTurn);
    const double angleError = errors[indexOf(Parameter::Theta20)];
    if (!data.crank && !(std::abs(angle) <= std::max(kSameAngle, kStandardErrors * angleError))) {
        const double late = roundest(angle / given.omega2, angleError / std::abs(given.omega2), std::array{1.0});
        append(conventions, data, Kind::TimeShift, late, none);
        p.theta20 = std::remainder(p.theta20 - late * p.omega2, kTurn);
    }
    const bool isAllowed = !conventions.empty() && conventions.size() <= mostConventions;
    return isAllowed ? result : WholeFileReading{{}, found, standardError};
}

} // namespace slidercrank
