// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_judge.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace slidercrank
{

namespace
{

using enum Convention::Kind;
using Outcome = Identification::Outcome;
using Reason = LeftOutColumn::Reason;

std::string describe(const Parameters &p)
{
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), "a %.9g b %.9g c %.9g omega2 %.9g theta20 %.9g %s", p.a, p.b, p.c, p.omega2,
                  p.theta20, p.branch == Branch::Open ? "open" : "crossed");
    return text.data();
}

/// How far a true claim may be off.
struct Tolerance {
    double standardErrors;
    double fraction; ///< of the size of the parameter
};

/// Returns a larger tolerance for an approximate claim, which may have systematic errors. It is largest if the table
/// has systematic deviations and the claim reports them: filtered values change a mechanism by some percent.
Tolerance toleranceOf(const Claim &claim)
{
    if (claim.found.outcome == Outcome::Identified) {
        return {5.0, claim.table.tolerance};
    }
    return {10.0, claim.table.isSystematic && claim.found.hasSystematicResiduals ? 0.1 : 0.05};
}

/// Returns the mechanism that a filter with this delay (s) shows: its crank lags by the angle that it turns in this
/// time.
Parameters delayed(Parameters p, double delay)
{
    p.theta20 -= p.omega2 * delay;
    return p;
}

/// Returns whether the parameters are, within the tolerance, those of a mechanism that produced the table or of one of
/// its mirror images.
bool isTrue(const Claim &claim, const Parameters &parameters)
{
    const Tolerance tolerance = toleranceOf(claim);
    std::vector<Parameters> truths = claim.table.others;
    if (claim.table.truth) {
        truths.push_back(*claim.table.truth);
        truths.push_back(delayed(*claim.table.truth, claim.table.delay));
    }
    return std::ranges::any_of(truths, [&](const Parameters &truth) {
        return std::ranges::any_of(mirrorImages(truth), [&](const Parameters &image) {
            return std::ranges::all_of(parameterErrors(claim, parameters, image), [=](const ParameterError &error) {
                return std::abs(error.difference) <=
                       std::max(tolerance.standardErrors * error.standardError, tolerance.fraction * error.size);
            });
        });
    });
}

// The next five functions describe what is false in a claim. Empty if nothing is.

/// Checks the mechanism and its rounded values. If the systematic deviations of a table do not show in the fit, the
/// mechanism may differ from the true one. A motion that no slider-crank makes may be approximated, but without
/// standard errors.
std::string falseMechanism(const Claim &claim)
{
    const ClaimTable &table = claim.table;
    const Identification &found = claim.found;
    const auto isFinite = [](double error) { return std::isfinite(error); };
    if (table.hasTooFewValues) {
        return "found in next to nothing";
    }
    if (!table.truth) {
        return found.outcome == Outcome::Identified || std::ranges::any_of(found.standardErrors, isFinite)
                   ? "is " + describe(found.parameters) + ", not a slider-crank"
                   : "";
    }
    for (const Parameters &parameters : {found.parameters, found.rounded}) {
        if (!isTrue(claim, parameters) && !(table.isSystematic && explainsExactly(claim, parameters))) {
            return "is " + describe(parameters) + ", not " + describe(*table.truth);
        }
    }
    return "";
}

/// Checks the number of conventions, and that a different origin is reported only for columns that have one.
std::string falseConvention(const Claim &claim)
{
    const ClaimTable &table = claim.table;
    const bool hidesDeviations = table.isSystematic && explainsExactly(claim, claim.found.parameters);
    std::size_t count = 0;
    for (const ConventionFinding &finding : claim.found.conventions) {
        const auto &[kind, channels, amount] = finding.convention;
        const bool isOrigin = kind == ZeroPoint;
        const ClaimColumn *column = channels.empty() ? nullptr : table.find(std::string(nameOf(channels.front())));
        if (isOrigin && column && column->content == ClaimColumn::Content::Systematic && !column->hasOrigin) {
            if (!hidesDeviations) {
                return "an invented origin of " + column->heading;
            }
            continue;
        }
        count += kind != WholeTurns ? 1U : 0U;
    }
    const bool isCountRight = count >= table.minConventions && count <= table.maxConventions;
    return isCountRight ? "" : std::to_string(count) + " conventions";
}

/// Checks that no column that contains the motion was left out as finite differences, as a different motion or,
/// although the crank speed is constant, because of an uneven speed.
std::string falseLeftOut(const Claim &claim)
{
    for (const LeftOutColumn &leftOut : claim.found.leftOut) {
        const ClaimColumn *column = claim.table.find(std::string(nameOf(leftOut.channel)));
        const bool isMotion = column && claim.table.truth && column->content == ClaimColumn::Content::Motion;
        const bool isWrongReason = leftOut.reason == Reason::FiniteDifferences ||
                                   leftOut.reason == Reason::OtherMotion ||
                                   (leftOut.reason == Reason::UnevenSpeed && !claim.table.isCrankUneven);
        if (isMotion && isWrongReason) {
            return column->heading + " is the motion";
        }
    }
    return "";
}

/// Checks the least and the greatest speed of an uneven crank with a tolerance of 5 %.
std::string falseDrive(const Claim &claim)
{
    constexpr double kSpeedTolerance = 0.05;
    const ClaimTable &table = claim.table;
    if (const auto &drive = claim.found.drive) {
        const Values speeds = (table.exact(kTheta2Diff, table.times) / kDegreesPerRadian).abs();
        const double least = std::min(std::abs(drive->least), std::abs(drive->greatest));
        const double greatest = std::max(std::abs(drive->least), std::abs(drive->greatest));
        if (!(std::abs(least - speeds.minCoeff()) <= kSpeedTolerance * speeds.maxCoeff()) ||
            !(std::abs(greatest - speeds.maxCoeff()) <= kSpeedTolerance * speeds.maxCoeff())) {
            return "the crank does not turn like that";
        }
    }
    return "";
}

/// Checks the length that is said to explain the difference from the given mechanism, with a tolerance of 1 %.
std::string falseChange(const Claim &claim)
{
    constexpr double kTolerance = 0.01;
    const ClaimTable &table = claim.table;
    const auto &change = claim.found.change;
    if (!change || !table.wrongGiven) {
        return "";
    }
    const double error = change->value / valueOf(*table.truth, *table.wrongGiven) - 1.0;
    const bool isRight = change->parameter == *table.wrongGiven && std::abs(error) <= kTolerance;
    return isRight ? "" : "a different length has changed";
}

} // namespace

Claim::Claim(const ClaimTable &claimTable, const ReferenceData &data)
    : table(claimTable)
    , found(identify(data, Mechanism(table.givenMechanism)))
    , read(data)
{
    for (const ConventionFinding &finding : found.conventions) {
        read = applied(finding.convention, std::move(read));
    }
}

bool Claim::isUsed(Channel channel) const
{
    return canBeFitted(channel) && std::ranges::count(found.leftOut, channel, &LeftOutColumn::channel) == 0;
}

std::vector<ParameterError> parameterErrors(const Claim &claim, const Parameters &parameters, const Parameters &truth)
{
    const std::array sizes = parameterSizes(truth);
    std::vector<ParameterError> errors;
    for (const Parameter parameter : kAllParameters) {
        const std::size_t i = indexOf(parameter);
        const bool isLength = parameter <= Parameter::C;
        const bool isRatio = claim.found.lengthScale != Identification::LengthScale::Measured && isLength;
        const bool isOfUnevenDrive = claim.table.isCrankUneven && !isLength;
        if (isRatio ? parameter != Parameter::A : claim.found.identifiable[i] && !isOfUnevenDrive) {
            const double scale = isRatio ? parameters.a / truth.a : 1.0;
            const double difference = valueOf(parameters, parameter) - scale * valueOf(truth, parameter);
            const double error = claim.found.standardErrors[i];
            errors.push_back({parameter == Parameter::Theta20 ? std::remainder(difference, kTurn) : difference,
                              std::isfinite(error) ? error : 0.0, scale * sizes[i]});
        }
    }
    return errors;
}

Judgement judge(const Claim &claim)
{
    const bool isUneven = claim.table.isCrankUneven && claim.table.truth;
    const bool hasMechanism = claim.found.hasMechanism();
    Judgement judgement{claim.found.outcome};
    std::string &why = judgement.falseClaim;
    if (hasMechanism) {
        for (const auto &check : {falseMechanism, falseConvention, falseLeftOut, falseDrive, falseChange}) {
            why = why.empty() ? check(claim) : why;
        }
    }
    why = why.empty() ? falseResidual(claim) : why;
    judgement.isDetermined = isUneven || determinesItsMechanism(claim.table);
    judgement.isMissed = judgement.isDetermined && why.empty() && (!hasMechanism || (isUneven && !claim.found.drive));
    return judgement;
}

} // namespace slidercrank
