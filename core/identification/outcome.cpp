// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/outcome.h"

#include "core/identification/geometry.h"
#include "core/identification/residual_test.h"
#include "core/identification/round_values.h"
#include "core/identification/varying_speed.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Outcome = Identification::Outcome;
using Lack = Identification::Lack;
using Rejection = Identification::Rejection;
using LengthScale = Identification::LengthScale;

/// A parameter is left open if its standard error is a larger fraction of its size (parameterSize()): a value that is
/// less certain is of no use.
constexpr double kMaxRelativeError = 0.2;

/// The limit for the relative error of a, beyond which all lengths are left open. Standard errors are computed as if
/// the motion were a linear function of the unknowns. If a is less certain than this, the motion is not linear within
/// its error, and the standard errors of all parameters are too small.
constexpr double kMaxErrorOfCrank = 0.03;

/// A parameter is left open if systematic residuals can change it by a larger fraction of its size (see
/// worstCaseErrors()).
constexpr double kMaxSystematicError = 0.1;

/// A parameter is left open if it would change by a larger fraction of its size at a varying speed of the crank that
/// explains the residuals as well (see changesByRipple()).
constexpr double kMaxChangeByRipple = 0.03;

/// The residual of fit.columns[indexInFit] in the units of files.
ColumnResidual describeResidual(const Observations &observations, const Fit &fit, Index indexInFit)
{
    const ObservedColumn &column = observations.columns[fit.columns[indexInFit]];
    const double largest = gapsAsZeros(fit.residuals.col(indexInFit)).abs().maxCoeff();
    const bool hasRange = !column.isConstant() && column.channel != kSliderLine; // R4_y is constant apart from noise
    return {.channel = column.channel,
            .rms = toFileUnit(column.channel, fit.rms[indexInFit]),
            .max = toFileUnit(column.channel, largest),
            .percentOfRange = hasRange ? 100.0 * largest / column.range : 0.0};
}

/// How far the parameters may be off: their standard errors, enlarged if the residuals are systematic. Standard errors
/// assume that the errors of many rows cancel. Systematic errors may all have the same sign, and n of these change a
/// parameter √n times as much as n independent ones of the same size. The standard errors already contain the square
/// root of the dependence of the residuals.
ParameterErrors worstCaseErrors(const LastFit &lastFit, bool areResidualsSystematic)
{
    ParameterErrors errors = lastFit.standardErrors;
    if (areResidualsSystematic) {
        for (double &error : errors) {
            error *= std::sqrt(lastFit.fit.valueCount() / lastFit.dependence);
        }
    }
    return errors;
}

/// The largest error of a parameter, relative to its size, with which it counts as determined.
double maxRelativeError(Parameter parameter, bool areResidualsSystematic)
{
    if (areResidualsSystematic) {
        return kMaxSystematicError;
    }
    return parameter == Parameter::A ? kMaxErrorOfCrank : kMaxRelativeError;
}

/// Whether all columns of the fit are those of one coordinate, such as R4_x and its derivatives.
bool hasOneCoordinate(const LastFit &lastFit)
{
    const std::vector<ObservedColumn> &columns = lastFit.observations.columns;
    const Indices &used = lastFit.fit.columns;
    return std::ranges::all_of(
        used, [&](Index k) { return columns[k].channel.coordinate == columns[used.front()].channel.coordinate; });
}

/// Whether the columns of the fit are positions over the time alone, at least one of which has a free origin.
bool arePositionsWithFreeOrigin(const LastFit &lastFit)
{
    const Observations &observations = lastFit.observations;
    return !observations.hasAngle() && !observations.containDerivatives(lastFit.fit.columns) &&
           std::ranges::any_of(lastFit.fit.unknowns, &Unknown::isOrigin);
}

/// Whether systematic residuals, if there are any, would leave every parameter open: the columns belong to one
/// coordinate, so that no other one confirms the mechanism, and they are an arc, on which many motions resemble each
/// other, or positions that need an origin, which behind a filter resemble those of a different mechanism with a
/// different origin.
bool canBeAmbiguous(const LastFit &lastFit)
{
    return hasOneCoordinate(lastFit) &&
           (isShortArc(lastFit.observations, lastFit.fit.model) || arePositionsWithFreeOrigin(lastFit));
}

/// Which of the parameters that are unknowns of the fit the file leaves open. `errors`: the result of
/// worstCaseErrors(). A parameter of the drive may have the error NaN, which leaves it open only if all parameters are.
ParameterFlags findOpenParameters(const LastFit &lastFit, const ParameterErrors &errors, bool areResidualsSystematic)
{
    const Fit &fit = lastFit.fit;
    const Parameters &m = fit.model.mechanism;
    // A motion that is only approximately that of a long coupler hardly shows its length, however small the errors are.
    const bool isCouplerOpen = !lastFit.isExact && hidesLengths(m);
    const bool isEverythingOpen = areResidualsSystematic && canBeAmbiguous(lastFit);
    const ParameterErrors changes = lastFit.isExact ? ParameterErrors{} : changesByRipple(lastFit);
    ParameterFlags open{};
    for (const Unknown unknown : fit.unknowns) {
        if (const std::optional<Parameter> parameter = unknown.parameter) {
            const std::size_t i = indexOf(*parameter);
            const double size = parameterSize(*parameter, m);
            const bool isCouplerOrOffset = parameter == Parameter::B || parameter == Parameter::C;
            const bool dependsOnRipple = changes[i] > kMaxChangeByRipple * size;
            const bool isUncertain = errors[i] > maxRelativeError(*parameter, areResidualsSystematic) * size;
            open[i] = isEverythingOpen || (isCouplerOpen && isCouplerOrOffset) || dependsOnRipple || isUncertain;
        }
    }
    if (open[indexOf(Parameter::A)]) {
        open[indexOf(Parameter::B)] = true;
        open[indexOf(Parameter::C)] = true;
    }
    return open;
}

/// What the file lacks for the fit: values (FewValues), positions (UnevenSpeed), rows (FewRowsPerTurn) or Nothing.
Lack findLackOfValues(const LastFit &lastFit, const Drive &drive)
{
    constexpr double kSpareValues = 3.0;    // with fewer, small residuals prove nothing
    constexpr double kMinRowsPerTurn = 4.0; // with fewer, a faster crank may give the same positions
    const Fit &fit = lastFit.fit;
    const Observations &observations = lastFit.observations;
    if (fit.valueCount() < static_cast<double>(fit.unknowns.size()) + kSpareValues) {
        return Lack::FewValues;
    }
    if (drive.kind == Drive::Kind::Uneven && observations.containDerivatives(fit.columns)) {
        return Lack::UnevenSpeed;
    }
    if (fit.model.followsAngle || observations.containDerivatives(fit.columns)) {
        return Lack::Nothing;
    }
    const double turns = std::abs(fit.model.mechanism.omega2) * observations.span() / kTurn;
    const bool isSparse = static_cast<double>(observations.size()) < kMinRowsPerTurn * turns;
    return isSparse ? Lack::FewRowsPerTurn : Lack::Nothing;
}

/// Why no mechanism explains the file; nullopt if the mechanism of the last fit does.
std::optional<Rejection> findRejection(const Findings &findings)
{
    if (std::ranges::find(findings.leftOut, kSliderLine, &LeftOutColumn::channel) != findings.leftOut.end()) {
        return Rejection::SliderLine;
    }
    const LastFit &lastFit = findings.lastFit;
    const auto isColumnExplained = [&](Index indexInFit) {
        return isExplained(lastFit.observations, lastFit.fit, indexInFit);
    };
    const bool areExplained = std::ranges::all_of(lastFit.fit.indicesInFit(), isColumnExplained);
    return areExplained ? std::nullopt : std::optional(Rejection::LargeResiduals);
}

/// Replaces the parameters that are not determined by those of the given mechanism. `isDetermined`: whether
/// a parameter is determined, at indexOf(Parameter).
Parameters completedByGiven(Parameters found, const ParameterFlags &isDetermined, const Parameters &given)
{
    for (const Parameter parameter : kAllParameters) {
        if (!isDetermined[indexOf(parameter)]) {
            valueOf(found, parameter) = valueOf(given, parameter);
        }
    }
    return found;
}

/// Describes a speed that changes; nullopt if the file does not show that it does. `found`: the parameters at t = 0 of
/// the file.
std::optional<UnevenDrive> describeUnevenDrive(const Drive &drive, const Parameters &found)
{
    if (!drive.hasChangingSpeed()) {
        return std::nullopt;
    }
    UnevenDrive result{.omega2 = found.omega2,
                       .standardError = drive.speedErrorAtZero,
                       .least = drive.minSpeed,
                       .greatest = drive.maxSpeed};
    if (drive.kind == Drive::Kind::RunUp) {
        result.alpha2 = drive.alpha2;
    }
    return result;
}

/// Sets the parameters that an insufficient file determines, and their errors. The others are those of the given
/// mechanism. `errors`: the result of worstCaseErrors().
void setDeterminedParameters(Identification &result, const Findings &findings, const ParameterErrors &errors,
                             const Parameters &given)
{
    const LastFit &lastFit = findings.lastFit;
    ParameterFlags determined{};
    for (const Unknown unknown : lastFit.fit.unknowns) {
        if (unknown.parameter) {
            const std::size_t i = indexOf(*unknown.parameter);
            determined[i] = !result.openParameters[i] && std::isfinite(errors[i]);
            result.standardErrors[i] = determined[i] ? errors[i] : kNone;
        }
    }
    result.parameters = completedByGiven(parametersAtTimeZero(lastFit.fit.model, lastFit.observations, findings.drive),
                                         determined, given);
    result.rounded = result.parameters;
}

/// What determines the lengths of the last fit.
LengthScale findLengthScale(const LastFit &lastFit)
{
    const Observations &observations = lastFit.observations;
    const Indices &columns = lastFit.fit.columns;
    if (areLengthsDetermined(observations, columns)) {
        return LengthScale::Measured;
    }
    return observations.containOnlyAngles(columns) ? LengthScale::GivenCrank : LengthScale::GivenSpeed;
}

/// The magnitudes of the possible speeds if there are several; otherwise empty.
std::vector<double> possibleMagnitudes(const std::vector<double> &speeds)
{
    std::vector<double> magnitudes;
    if (speeds.size() > 1) {
        std::ranges::transform(speeds, std::back_inserter(magnitudes), [](double speed) { return std::abs(speed); });
    }
    return magnitudes;
}

/// Which parameters the file can contain and determines.
ParameterFlags identifiableParameters(const Findings &findings)
{
    const Fit &fit = findings.lastFit.fit;
    ParameterFlags identifiable{};
    for (const Parameter length : kLengths) {
        identifiable[indexOf(length)] = areLengthsDetermined(findings.lastFit.observations, fit.columns);
    }
    identifiable[indexOf(Parameter::Omega2)] = fit.isFree(Parameter::Omega2) || findings.drive.hasChangingSpeed();
    identifiable[indexOf(Parameter::Theta20)] = !fit.model.followsAngle || findings.drive.kind == Drive::Kind::RunUp;
    return identifiable;
}

/// Adds the mechanisms of the other mirror images. `isFromFit`: which of their parameters are those of the fit; the
/// others are those of the given mechanism.
void addAlternatives(Identification &result, const Findings &findings, const ParameterFlags &isFromFit,
                     const Parameters &given)
{
    using Symmetry = AlternativeMechanism::Symmetry;
    const Observations &observations = findings.lastFit.observations;
    const bool areAngles = observations.containOnlyAngles(findings.lastFit.fit.columns);
    const Symmetry symmetryOfSameAssembly = areAngles ? Symmetry::ReversedCrank : Symmetry::MirrorImage;
    for (const Model &image : findings.otherMirrorImages) {
        const Parameters parameters =
            completedByGiven(parametersAtTimeZero(image, observations, findings.drive), isFromFit, given);
        const bool hasSameAssembly = parameters.branch == result.parameters.branch;
        result.alternatives.push_back({hasSameAssembly ? symmetryOfSameAssembly : Symmetry::OtherAssembly, parameters});
    }
}

/// Sets the mechanism of an identified or approximate file, its drive and the alternatives. Requires that
/// result.identifiable has been set.
void setMechanism(Identification &result, const Findings &findings, const Parameters &given)
{
    const LastFit &lastFit = findings.lastFit;
    ParameterFlags isFromFit = result.identifiable;
    for (const Parameter length : kLengths) {
        isFromFit[indexOf(length)] = true; // if only their ratios are identifiable, the fit has kept the given a or ω2
    }
    const Parameters unrounded = parametersAtTimeZero(lastFit.fit.model, lastFit.observations, findings.drive);
    const Parameters rounded = roundedParameters(lastFit, unrounded);
    result.parameters = completedByGiven(unrounded, isFromFit, given);
    result.rounded = completedByGiven(rounded, isFromFit, given);
    result.drive = describeUnevenDrive(findings.drive, unrounded);
    addAlternatives(result, findings, isFromFit, given);
}

/// Sets which parameters of the mechanism of an identified or approximate file are known and how exactly, and which
/// rows and columns it does not explain. `data`: the file.
void setFindings(Identification &result, const ReferenceData &data, const Findings &findings)
{
    const LastFit &lastFit = findings.lastFit;
    result.lengthScale = findLengthScale(lastFit);
    result.identifiable = identifiableParameters(findings);
    if (!result.hasSystematicResiduals) {
        result.standardErrors = lastFit.standardErrors;
    }
    result.possibleSpeeds = possibleMagnitudes(findings.speeds);
    result.change = findings.change;
    result.leftOut = findings.leftOut;
    for (const Index row : lastFit.excludedRows) {
        const Index rowOfFile = lastFit.observations.rows[row];
        result.excludedRows.push_back(data.lineOfRow(static_cast<std::size_t>(rowOfFile)));
    }
}

} // namespace

Identification::Lack findLack(const Observations &observations)
{
    constexpr Index kMinRows = 4; // no fit has fewer unknowns than three
    if (observations.size() < kMinRows) {
        return Lack::FewValues;
    }
    return shapeColumns(observations).empty() ? Lack::NothingMoves : Lack::Nothing;
}

Identification judge(const ReferenceData &data, const Findings &findings, const Parameters &given)
{
    const LastFit &lastFit = findings.lastFit;
    const Observations &observations = lastFit.observations;
    const Fit &fit = lastFit.fit;
    Identification result{.parameters = given, .rounded = given, .lengthUnit = observations.lengthUnit};
    if (!fit.isFinite()) {
        result.rejection = Rejection::CannotBeAssembled;
        return result;
    }
    for (const Index indexInFit : fit.indicesInFit()) {
        result.residuals.push_back(describeResidual(observations, fit, indexInFit));
    }
    result.iterations = fit.iterations;
    result.conditionNumber = conditionNumber(fit);
    result.hasSystematicResiduals = isSystematic(observations, fit);
    result.lack = findLackOfValues(lastFit, findings.drive);
    if (result.lack != Lack::Nothing) {
        result.outcome = Outcome::Insufficient;
        return result;
    }
    if (const std::optional<Rejection> rejection = findRejection(findings)) {
        result.outcome = Outcome::None;
        result.rejection = *rejection;
        return result;
    }
    const ParameterErrors errors = worstCaseErrors(lastFit, result.hasSystematicResiduals);
    const ParameterFlags open = findOpenParameters(lastFit, errors, result.hasSystematicResiduals);
    if (std::ranges::find(open, true) != open.end()) {
        result.outcome = Outcome::Insufficient;
        result.lack = Lack::OpenParameters;
        result.openParameters = open;
        setDeterminedParameters(result, findings, errors, given);
        return result;
    }
    result.outcome = lastFit.isExact ? Outcome::Identified : Outcome::Approximate;
    setFindings(result, data, findings);
    setMechanism(result, findings, given);
    return result;
}

} // namespace slidercrank
