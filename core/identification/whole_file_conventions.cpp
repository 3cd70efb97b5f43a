// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/whole_file_conventions.h"

#include "core/identification/noise.h"
#include "core/identification/round_number.h"

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

/// How far a parameter may be from the given one: three standard errors, or kTypedDifference of parameterSize() if this
/// is more, as in an exact file, whose standard errors are tiny. (An angle may differ by 0.1°.)
double toleranceOf(Parameter parameter, const Parameters &given, double standardError)
{
    const double ofTyping = kTypedDifference * parameterSize(parameter, given);
    return std::isfinite(standardError) ? std::max(ofTyping, kStandardErrors * standardError) : ofTyping;
}

/// Whether two mechanisms have the same lengths and speed, within toleranceOf() each. θ20 and the assembly may differ.
bool haveSameLengthsAndSpeed(const Parameters &found, const Parameters &given, const ParameterErrors &errors)
{
    constexpr std::array kCompared{Parameter::A, Parameter::B, Parameter::C, Parameter::Omega2};
    return std::ranges::all_of(kCompared, [&](Parameter parameter) {
        return std::abs(valueOf(found, parameter) - valueOf(given, parameter)) <=
               toleranceOf(parameter, given, errors[indexOf(parameter)]);
    });
}

/// Appends a convention of all columns of the file for whose channel `isChanged` returns true.
template <class Predicate>
void appendForColumns(std::vector<ConventionFinding> &conventions, const ReferenceData &data, Kind kind, double amount,
                      const Predicate &isChanged)
{
    Convention &convention = conventions.emplace_back(ConventionFinding{{kind, {}, amount}}).convention;
    for (const ReferenceSeries &series : data.series) {
        if (isChanged(series.channel)) {
            convention.channels.push_back(series.channel);
        }
    }
}

/// The factors by which values may have to be multiplied because their unit is wrong. `unitInFile`: the size of this
/// unit in mm, ° or s, as the heading states it and conventions change it; 1 if none is stated. Values in mm, ° or s,
/// or without a unit, may really be in any of `units`; values in a different unit may really be in mm, ° or s.
std::vector<double> possibleFactors(std::span<const double> units, double unitInFile)
{
    if (unitInFile == 1.0) {
        return {units.begin(), units.end()};
    }
    return {1.0, 1.0 / unitInFile};
}

/// The one of some factors whose ratio to |wanted| is nearest to 1.
double nearestFactor(const std::vector<double> &factors, double wanted)
{
    return std::ranges::min(factors, {}, [&](double factor) { return std::abs(std::log(std::abs(wanted) / factor)); });
}

/// The factors by which all lengths and all times of a file are multiplied.
struct WholeFileFactors {
    double length = 1.0;
    double time = 1.0;       ///< also divides derivatives: those of order n by its nth power
    bool isReversed = false; ///< y has the opposite direction, so that angles are counted in the opposite one, too
};

/// The factors after which a and the speed of the mechanism found are nearest to those of the given one.
WholeFileFactors findFactorsTowards(const Parameters &given, const Parameters &found, const ReferenceData &data)
{
    const auto isLength = [](const ReferenceSeries &series) { return !isAngle(series.channel.coordinate); };
    const auto length = std::ranges::find_if(data.series, isLength);
    const double lengthUnit = length != data.series.end() ? length->rounding.unitFactor : 1.0;
    WholeFileFactors factors{.length = nearestFactor(possibleFactors(kLengthUnits, lengthUnit), given.a / found.a)};
    if (!data.crank) { // a table over the crank angle has no times and shows no sense of rotation
        factors.time =
            nearestFactor(possibleFactors(kTimeUnits, data.timeRounding.unitFactor), found.omega2 / given.omega2);
        factors.isReversed = found.omega2 * given.omega2 < 0.0;
    }
    return factors;
}

/// Appends the conventions that multiply the columns by `factors`. θ3 of the crossed assembly is near 180°; if it is
/// negated, it is near -180°, and one turn is added to it. `branch`: the assembly of the mechanism found.
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
                         [](Channel channel) { return isAngle(channel.coordinate) || isAlongY(channel.coordinate); });
        const Channel coupler{Theta3, Order::Position};
        if (branch == Branch::Crossed && data.find(coupler)) {
            appendForColumns(conventions, data, Kind::WholeTurns, kTurnInDegrees,
                             [&](Channel channel) { return channel == coupler; });
        }
    }
}

/// Changes the parameters and their errors to those that are found after the columns have been multiplied. If angles
/// are reversed, the mechanism is mirrored in the x axis: c, ω2 and θ20 change their signs.
void multiplyMechanism(WholeFileConventions &result, const WholeFileFactors &factors)
{
    Parameters &found = result.parameters;
    for (const Parameter length : kLengths) {
        valueOf(found, length) *= factors.length;
        result.standardErrors[indexOf(length)] *= factors.length;
    }
    const double sense = factors.isReversed ? -1.0 : 1.0;
    found.c *= sense;
    found.omega2 *= sense / factors.time;
    found.theta20 *= sense;
    result.standardErrors[indexOf(Parameter::Omega2)] /= factors.time;
}

/// If the crank is not at the given angle at t = 0, appends a late start, and turns the crank of the mechanism found
/// back by its motion in that time. The two mechanisms have the same speed, apart from its error.
void appendLateStart(WholeFileConventions &result, const Parameters &given)
{
    Parameters &p = result.parameters;
    const double angle = std::remainder(p.theta20 - given.theta20, kTurn);
    const double error = result.standardErrors[indexOf(Parameter::Theta20)];
    if (std::abs(angle) > toleranceOf(Parameter::Theta20, given, error)) {
        const double delay = // s
            findRoundNumber(angle / given.omega2, error / std::abs(given.omega2), std::array{1.0}).value;
        result.conventions.push_back({{Kind::TimeShift, {}, delay}});
        p.theta20 = std::remainder(p.theta20 - delay * p.omega2, kTurn);
    }
}

} // namespace

WholeFileConventions findWholeFileConventions(const ReferenceData &data, const Parameters &found,
                                              const ParameterErrors &standardErrors, const Parameters &given)
{
    // Several changes lead to the given mechanism by chance more often than one. A file with θ2 shows how the crank
    // turns and where it starts; it needs no second change.
    const std::size_t maxConventions = data.find(kCrankAngle) ? 1 : 2;
    const WholeFileConventions unchanged{.parameters = found, .standardErrors = standardErrors};
    const WholeFileFactors factors = findFactorsTowards(given, found, data);
    WholeFileConventions result = unchanged;
    multiplyMechanism(result, factors);
    if (!haveSameLengthsAndSpeed(result.parameters, given, result.standardErrors)) {
        return unchanged;
    }
    appendFactors(result.conventions, factors, data, found.branch);
    if (found.branch != given.branch) {
        result.conventions.push_back({{Kind::OtherAssembly, {}, 1.0}});
    }
    if (!data.crank) {
        appendLateStart(result, given);
    }
    return result.conventions.size() <= maxConventions ? result : unchanged;
}

} // namespace slidercrank
