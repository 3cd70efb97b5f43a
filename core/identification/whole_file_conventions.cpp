// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/whole_file_conventions.h"

#include "core/identification/round_values.h"

#include "core/import/crank_angles.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

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
void appendForColumns(std::vector<ConventionFinding> &conventions, const ReferenceData &data, Kind kind, double amount,
                      const Predicate &concerns)
{
    Convention &convention = conventions.emplace_back(ConventionFinding{{kind, {}, amount}}).convention;
    for (const ReferenceSeries &series : data.series) {
        if (concerns(series.channel)) {
            convention.channels.push_back(series.channel);
        }
    }
}

/// The factor nearest to |wanted| that corrects a wrong unit: values in the default unit, which includes those without
/// a unit, may be in one of `units`, and those in one of `units` may be in the default unit.
double nearestFactor(std::span<const double> units, double wanted, double unitOfHeading)
{
    const auto distance = [&](double factor) { return std::abs(std::log(std::abs(wanted) / factor)); };
    double nearest = 1.0;
    for (const double unit : units) {
        for (const double factor : {unit, 1.0 / unit}) {
            const bool isPossible =
                unitOfHeading == 1.0 ? factor == unit : std::abs(factor * unitOfHeading - 1.0) < kSameUnit;
            nearest = isPossible && distance(factor) < distance(nearest) ? factor : nearest;
        }
    }
    return nearest;
}

/// What all columns of a file are multiplied by.
struct WholeFileFactors {
    double length = 1.0;
    double time = 1.0;       ///< of the times; derivatives are multiplied by its inverse powers
    bool isReversed = false; ///< angles are counted in the opposite direction
};

/// The factors after which the mechanism found is nearest to the given one.
WholeFileFactors findFactorsTowards(const Parameters &given, const Parameters &found, const ReferenceData &data)
{
    const auto isLength = [](const ReferenceSeries &series) { return !isAngle(series.channel.coordinate); };
    const auto length = std::ranges::find_if(data.series, isLength);
    const double lengthUnit = length != data.series.end() ? length->rounding.unitFactor : 1.0;
    WholeFileFactors factors{.length = nearestFactor(kLengthUnits, given.a / found.a, lengthUnit)};
    if (!data.crank) { // a table over the crank angle shows neither
        factors.time = nearestFactor(kTimeUnits, found.omega2 / given.omega2, data.timeRounding.unitFactor);
        factors.isReversed = found.omega2 * given.omega2 < 0.0;
    }
    return factors;
}

/// Appends the conventions of factors. θ3 of the crossed assembly is near 180°; negated, it is near -180°, and one turn
/// is added to it. `branch`: the assembly of the mechanism found.
void appendFactors(std::vector<ConventionFinding> &conventions, const WholeFileFactors &factors,
                   const ReferenceData &data, Branch branch)
{
    if (factors.length != 1.0) {
        appendForColumns(conventions, data, Kind::LengthUnit, factors.length,
                         [](Channel channel) { return !isAngle(channel.coordinate); });
    }
    if (factors.time != 1.0) {
        appendForColumns(conventions, data, Kind::TimeUnit, factors.time,
                         [](Channel channel) { return channel.order != Order::Position; });
    }
    if (factors.isReversed) {
        appendForColumns(conventions, data, Kind::Sign, -1.0,
                         [](Channel channel) { return isAngle(channel.coordinate); });
        const Channel coupler{Theta3, Order::Position};
        if (branch == Branch::Crossed && data.find(coupler)) {
            appendForColumns(conventions, data, Kind::WholeTurns, kTurn * kDegreesPerRadian,
                             [&](Channel channel) { return channel == coupler; });
        }
    }
}

/// Changes the parameters and their errors to those that are found after the columns have been multiplied. Reversed
/// angles are those of the image in the x axis: c, ω2 and θ20 change their sign.
void multiplyMechanism(WholeFileConventions &result, const WholeFileFactors &factors)
{
    Parameters &found = result.parameters;
    for (const Parameter length : kLengths) {
        valueOf(found, length) *= factors.length;
        result.standardError[indexOf(length)] *= factors.length;
    }
    const double sense = factors.isReversed ? -1.0 : 1.0;
    found.c *= sense;
    found.omega2 *= sense / factors.time;
    found.theta20 *= sense;
    result.standardError[indexOf(Parameter::Omega2)] /= factors.time;
}

/// If the crank is not at the given angle at t = 0, appends a late start, and turns the crank of the mechanism found by
/// as much as it turns in that time. The two mechanisms have the same speed, apart from its error.
void appendLateStart(WholeFileConventions &result, const Parameters &given)
{
    Parameters &p = result.parameters;
    const double angle = std::remainder(p.theta20 - given.theta20, kTurn);
    const double error = result.standardError[indexOf(Parameter::Theta20)];
    const double tolerance =
        std::isfinite(error) ? std::max(kTypedDifference, kStandardErrors * error) : kTypedDifference;
    if (std::abs(angle) > tolerance) {
        const double late =
            roundToFewestDigits(angle / given.omega2, error / std::abs(given.omega2), std::array{1.0}).value;
        result.conventions.push_back({{Kind::TimeShift, {}, late}});
        p.theta20 = std::remainder(p.theta20 - late * p.omega2, kTurn);
    }
}

} // namespace

WholeFileConventions findWholeFileConventions(const ReferenceData &data, const Parameters &found,
                                              const ParameterErrors &standardError, const Parameters &given)
{
    // Several changes lead to the given mechanism by chance more often than one. A file with θ2 shows how the crank
    // turns and where it starts; it needs no second change.
    const std::size_t maxConventions = data.find(kCrankAngle) ? 1 : 2;
    const WholeFileConventions none{.parameters = found, .standardError = standardError};
    const WholeFileFactors factors = findFactorsTowards(given, found, data);
    WholeFileConventions result = none;
    multiplyMechanism(result, factors);
    if (!areNear(result.parameters, given, result.standardError)) {
        return none;
    }
    appendFactors(result.conventions, factors, data, found.branch);
    if (found.branch != given.branch) {
        result.conventions.push_back({{Kind::Branch, {}, 1.0}});
    }
    if (!data.crank) {
        appendLateStart(result, given);
    }
    return result.conventions.size() <= maxConventions ? result : none;
}

} // namespace slidercrank
