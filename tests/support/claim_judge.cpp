// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_judge.h"

#include "core/mechanism/turn.h"
#include "tests/support/claim_precision.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace slidercrank
{

namespace
{

using enum Convention::Kind;
using Outcome = Identification::Outcome;

constexpr double kStandardErrors = 5.0; ///< largest accepted error of a claimed parameter

std::string describe(const Parameters &p)
{
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), "a %.9g b %.9g c %.9g omega2 %.9g theta20 %.9g %s", p.a, p.b, p.c, p.omega2,
                  p.theta20, p.branch == Branch::Open ? "open" : "crossed");
    return text.data();
}

double withoutTurns(Channel channel, double difference)
{
    return isAngle(channel.coordinate) && channel.order == Order::Position ? std::remainder(difference, 360.0)
                                                                           : difference;
}

Poses motionIn(const ClaimFile &file, Parameters p)
{
    if (file.isByAngle) {
        p.omega2 = file.truth->omega2;
        p.theta20 = file.truth->theta20;
    }
    return motionOf(p, file.instants);
}

/// Differences between the values of an image of the truth and those of the truth, in columns with a free origin.
using Offsets = std::map<std::size_t, double>;

/// Compares an image with the truth in the columns that contain the motion: within half a rounding step, and up to a
/// constant where the claim treats the origin as free. nullopt if a column distinguishes them.
std::optional<Offsets> compareImage(const Claim &claim, const Parameters &truth, const Parameters &image)
{
    constexpr double kSame = 1e-9; // of the column's size
    const Poses exact = motionIn(claim.file, truth);
    const Poses difference = motionIn(claim.file, image) - exact;
    Offsets offsets;
    for (const ClaimColumn &column : claim.file.columns) {
        if (column.content != ClaimColumn::Content::Motion) {
            continue;
        }
        const Index k = columnOf(column.shown);
        const bool isFree = claim.has(ZeroPoint, column.named) || claim.has(HalfTurn, column.named);
        const double offset = isFree ? withoutTurns(column.shown, static_cast<double>(difference(0, k))) : 0.0;
        const Values steps = 0.5 * column.form.stepsAt(column.values);
        const double size = kSame * (column.values - column.origin).abs().maxCoeff<Eigen::PropagateNumbers>();
        for (Index row = 0; row < steps.size(); ++row) {
            const double left = withoutTurns(column.shown, static_cast<double>(difference(row, k)) - offset);
            if (std::isfinite(static_cast<double>(exact(row, k)) + column.values[row]) &&
                !(std::abs(column.factor * left) <= std::max(steps[row], size))) {
                return std::nullopt;
            }
        }
        if (isFree) {
            offsets[indexOf(column.named)] = offset;
        }
    }
    return offsets;
}

bool areWithin(const std::vector<ParameterError> &errors, double standardErrors, double part)
{
    return std::ranges::all_of(errors, [=](const ParameterError &error) {
        return std::abs(error.difference) <= std::max(standardErrors * error.standardError, part * error.size);
    });
}

bool areSameChannels(const Channels &claimed, const Finding &expected)
{
    const auto isExpected = [&](Channel channel) { return std::ranges::count(expected.channels, channel) > 0; };
    return std::ranges::all_of(claimed, isExpected) &&
           (expected.isOptional || claimed.size() == expected.channels.size());
}

bool isSameFinding(const ClaimFile &file, const Convention &claimed, const Finding &expected, const Offsets &offsets)
{
    constexpr double kOriginTolerance = 2e-3;
    const bool isOfTheWholeFile = claimed.kind == TimeUnit || claimed.kind == Axis;
    if (claimed.kind != expected.kind || (!isOfTheWholeFile && !areSameChannels(claimed.channels, expected))) {
        return false;
    }
    if (claimed.kind != ZeroPoint || expected.amount == 0.0) {
        return expected.amount == 0.0 || std::abs(claimed.amount - expected.amount) <= 1e-9 * std::abs(expected.amount);
    }
    const Channel channel = claimed.channels.front();
    const auto offset = offsets.find(indexOf(channel));
    const double amount = expected.amount + (offset == offsets.end() ? 0.0 : offset->second);
    const double error = kStandardErrors * originError(file, channel);
    const double size = isAngle(channel.coordinate) ? kDegreesPerRadian : file.truth->a;
    return std::abs(withoutTurns(channel, claimed.amount - amount)) <=
           std::max(error, kOriginTolerance * std::max(std::abs(amount), size));
}

/// The mechanism of a claim, an approximate one (which may omit findings), one of its images (whose origins are not
/// reported), or one of its alternatives (which may interpret the file in another way and have no standard errors).
enum class Role { Mechanism, Approximation, Image, Alternative };

/// Returns whether the claim states the expected findings. Ignores whole turns. A column that is listed as left out
/// need not also be reported as no derivative.
bool areSameFindings(const Claim &claim, std::vector<Finding> missing, const Offsets &offsets, Role role)
{
    for (const ConventionFinding &finding : claim.diagnosis.conventions) {
        const Convention &convention = finding.convention;
        const auto same = std::ranges::find_if(missing, [&](const Finding &expected) {
            return isSameFinding(claim.file, convention, expected, offsets) ||
                   (role == Role::Image && convention.kind == ZeroPoint && expected.kind == ZeroPoint &&
                    convention.channels == expected.channels);
        });
        if (same != missing.end() && !same->isOptional) {
            missing.erase(same);
        } else if (same == missing.end() && convention.kind != WholeTurns) {
            return false;
        }
    }
    return role == Role::Approximation || std::ranges::all_of(missing, &Finding::isOptional);
}

/// Explains why a mechanism with the claim's findings is not a true interpretation. Empty if it is one.
std::string falseMechanism(const Claim &claim, const Parameters &parameters, Role role = Role::Mechanism)
{
    constexpr double kRoughly = 0.05;
    std::string why = "false findings, or no slider-crank:";
    for (const ConventionFinding &finding : claim.diagnosis.conventions) {
        why += ' ' + std::to_string(static_cast<int>(finding.convention.kind)) + " by " +
               std::to_string(finding.convention.amount);
    }
    for (const TrueInterpretation &interpretation : claim.file.interpretations) {
        for (const Parameters &image : mirrorImages(interpretation.mechanism)) {
            const auto offsets = compareImage(claim, interpretation.mechanism, image);
            if (!offsets ||
                (role != Role::Alternative && !areSameFindings(claim, interpretation.findings, *offsets, role))) {
                continue;
            }
            const std::vector<ParameterError> errors = parameterErrors(claim, parameters, image);
            if (image.branch == parameters.branch &&
                (areWithin(errors, kStandardErrors, claim.file.tolerance) ||
                 (role == Role::Alternative && areWithin(errors, 0.0, kRoughly)))) {
                return {};
            }
            why = "is " + describe(parameters) + ", not " + describe(image);
        }
    }
    return why;
}

/// Explains which claimed mechanism is false. Sets `isRight` if the claim contains the truth as its mechanism or in its
/// list.
std::string falseMechanisms(const Claim &claim, bool &isRight)
{
    using Why = Identification::Alternative::Why;
    if (claim.file.hasTooFewValues) {
        return "identified from next to nothing";
    }
    std::string why = falseMechanism(claim, claim.found.parameters);
    const bool isFirstRight = why.empty();
    isRight = isFirstRight;
    for (const auto &[reason, parameters] : claim.found.alternatives) {
        const bool isImage = reason != Why::Alias && reason != Why::AnotherMechanism;
        if (isImage && isFirstRight && !falseMechanism(claim, parameters, Role::Image).empty()) {
            return "a false image, " + describe(parameters);
        }
        isRight = isRight || (claim.found.outcome == Outcome::Ambiguous &&
                              falseMechanism(claim, parameters, isImage ? Role::Mechanism : Role::Alternative).empty());
    }
    if (isFirstRight && claim.found.outcome == Outcome::Identified) {
        why = falseMechanism(claim, claim.diagnosis.rounded);
        return why.empty() ? why : "rounded " + why;
    }
    return isRight ? "" : why;
}

/// Checks the findings of a claim without an identified mechanism. They must be those of a true interpretation, except
/// that `nearest` may state fitted origins. An approximate mechanism may omit findings and must not state origins.
bool areTrueWithoutMechanism(const Claim &claim)
{
    const auto &conventions = claim.diagnosis.conventions;
    const auto isOrigin = [](const ConventionFinding &finding) { return finding.convention.kind == ZeroPoint; };
    if (conventions.empty() || (claim.isNearest() && std::ranges::all_of(conventions, isOrigin))) {
        return true;
    }
    const Role role = claim.isApproximate() ? Role::Approximation : Role::Mechanism;
    return !(claim.isApproximate() && std::ranges::any_of(conventions, isOrigin)) &&
           std::ranges::any_of(claim.file.interpretations, [&](const TrueInterpretation &interpretation) {
               return areSameFindings(claim, interpretation.findings, {}, role);
           });
}

/// Checks the claimed crank speeds with a tolerance of 5 %.
bool areSpeedsTrue(const Claim &claim)
{
    const auto &claimed = claim.diagnosis.unevenCrank;
    const auto &actual = claim.file.crankSpeeds;
    const auto isNear = [](double speed, double actualSpeed) {
        return std::abs(speed - actualSpeed) <= 0.05 * std::abs(actualSpeed);
    };
    return !claimed || (actual && isNear(claimed->atStart, (*actual)[0]) && isNear(claimed->atEnd, (*actual)[1]));
}

/// Checks the parameter that is said to explain the difference to the given mechanism.
bool isChangeTrue(const Claim &claim)
{
    const auto &change = claim.diagnosis.change;
    const auto &wrong = claim.file.wrongGiven;
    return !change || !wrong ||
           (change->parameter == *wrong && std::abs(change->value / valueOf(*claim.file.truth, *wrong) - 1.0) <= 0.01);
}

std::string falseClaim(const Claim &claim, bool &isRight)
{
    isRight = claim.isApproximate() && claim.file.mayBeApproximate;
    const std::string why = claim.isIdentified()             ? falseMechanisms(claim, isRight)
                            : areTrueWithoutMechanism(claim) ? ""
                                                             : "finds conventions without an exact mechanism";
    return !why.empty()            ? why
           : !areSpeedsTrue(claim) ? "the crank does not turn unevenly like that"
           : !isChangeTrue(claim)  ? "another parameter has changed"
                                   : falseDeviation(claim);
}

} // namespace

Claim::Claim(const ClaimFile &claimFile, const ReferenceData &referenceData)
    : file(claimFile)
    , data(referenceData)
    , diagnosis(diagnose(data, Mechanism(file.given)))
    , read(data)
{
    for (const ConventionFinding &finding : diagnosis.conventions) {
        read = applied(finding.convention, std::move(read));
    }
}

bool Claim::isIdentified() const
{
    return found.outcome == Outcome::Identified || found.outcome == Outcome::Ambiguous;
}

bool Claim::has(Convention::Kind kind, Channel channel) const
{
    return std::ranges::any_of(diagnosis.conventions, [&](const ConventionFinding &finding) {
        return finding.convention.kind == kind && std::ranges::count(finding.convention.channels, channel) > 0;
    });
}

bool Claim::isLeftOut(Channel channel) const
{
    return std::ranges::count(found.leftOut, channel, &Identification::LeftOut::channel) > 0;
}

std::vector<ParameterError> parameterErrors(const Claim &claim, const Parameters &parameters, const Parameters &truth)
{
    const std::array sizes = parameterSizes(truth);
    std::vector<ParameterError> errors;
    for (const Parameter parameter :
         {Parameter::A, Parameter::B, Parameter::C, Parameter::Omega2, Parameter::Theta20}) {
        const std::size_t i = indexOf(parameter);
        const bool isLength = parameter <= Parameter::C;
        const bool isRatio = claim.found.onlyRatios && isLength; // b and c scale with the given a
        if (isRatio ? parameter != Parameter::A : claim.found.identifiable[i]) {
            const double scale = isRatio ? parameters.a / truth.a : 1.0;
            const double difference = valueOf(parameters, parameter) - scale * valueOf(truth, parameter);
            const double error = claim.found.standardError[i];
            errors.push_back({parameter == Parameter::Theta20 ? std::remainder(difference, kTurn) : difference,
                              std::isfinite(error) ? error : 0.0, scale * sizes[i]});
        }
    }
    return errors;
}

Judgement judge(const Claim &claim)
{
    Judgement judgement{claim.found.outcome};
    bool isRight = false;
    judgement.falseClaim = falseClaim(claim, isRight);
    judgement.isDetermined = claim.file.crankSpeeds || determinesItsMechanism(claim.file);
    judgement.isMissed = judgement.isDetermined && (claim.file.crankSpeeds ? !claim.diagnosis.unevenCrank
                                                                           : judgement.falseClaim.empty() && !isRight);
    return judgement;
}

} // namespace slidercrank
