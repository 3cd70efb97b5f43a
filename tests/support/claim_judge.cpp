// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_judge.h"

#include "core/identification/hypothesis.h"
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

std::string describe(const Parameters &p)
{
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), "a %.9g b %.9g c %.9g omega2 %.9g theta20 %.9g %s", p.a, p.b, p.c, p.omega2,
                  p.theta20, p.branch == Branch::Open ? "open" : "crossed");
    return text.data();
}

/// Returns whether a mechanism is one that makes the file, or an image of it, within 5 standard errors or a relative
/// tolerance.
bool isTrue(const Claim &claim, const Parameters &parameters, double tolerance)
{
    constexpr double kStandardErrors = 5.0;
    std::vector<Parameters> truths = claim.file.others;
    if (claim.file.truth) {
        truths.push_back(*claim.file.truth);
    }
    return std::ranges::any_of(truths, [&](const Parameters &truth) {
        return std::ranges::any_of(mirrorImages(truth), [&](const Parameters &image) {
            return image.branch == parameters.branch &&
                   std::ranges::all_of(parameterErrors(claim, parameters, image), [=](const ParameterError &error) {
                       return std::abs(error.difference) <=
                              std::max(kStandardErrors * error.standardError, tolerance * error.size);
                   });
        });
    });
}

/// Explains which claimed mechanism is false. Sets `isRight` if the claim contains the truth as its mechanism or in its
/// list. Where systematic deviations are not visible, the file cannot show that the mechanism is another one.
std::string falseMechanism(const Claim &claim, bool &isRight)
{
    using Why = Identification::Alternative::Why;
    constexpr double kRoughly = 0.05;
    const ClaimFile &file = claim.file;
    if (file.hasTooFewValues) {
        return "identified from next to nothing";
    }
    const auto isAccurate = [&](const Parameters &parameters) {
        return isTrue(claim, parameters, file.tolerance) ||
               (file.mayBeApproximate && explains(claim, parameters, true));
    };
    isRight = isAccurate(claim.found.parameters);
    const bool isFirstRight = isRight;
    const bool hasOrigin = std::ranges::any_of(
        claim.diagnosis.conventions, [](const ConventionFinding &finding) { return finding.kind == ZeroPoint; });
    for (const auto &[reason, parameters] : claim.found.alternatives) {
        const bool isAnother = reason == Why::Alias || reason == Why::AnotherMechanism;
        const bool isListed = claim.found.outcome == Outcome::Ambiguous && isTrue(claim, parameters, kRoughly);
        if (!isAnother && !hasOrigin && isFirstRight && !isAccurate(parameters) &&
            !(isTrue(claim, parameters, kRoughly) && explains(claim, parameters, false))) {
            return "a false image, " + describe(parameters);
        }
        isRight = isRight || isListed;
    }
    if (!isRight) {
        return "is " + describe(claim.found.parameters) + ", not " +
               (file.truth ? describe(*file.truth) : "a slider-crank");
    }
    const auto isTruth = [&](const Parameters &parameters) { return areNear(*file.truth, parameters, kRoughly); };
    const bool hasOnlyOrigin = hasOrigin && claim.diagnosis.conventions.size() == 1 && !file.isByAngle;
    if (file.truth && !file.mayBeApproximate && hasOnlyOrigin && !claim.found.onlyRatios &&
        !isTruth(claim.found.parameters) &&
        std::ranges::none_of(claim.found.alternatives, isTruth, &Identification::Alternative::parameters)) {
        return "names only an image, " + describe(claim.found.parameters) + ", of " + describe(*file.truth);
    }
    return claim.found.outcome == Outcome::Identified && !isAccurate(claim.diagnosis.rounded) ? "false round numbers"
                                                                                              : "";
}

/// Checks the number of conventions, that omitted derivatives do not belong to the motion, and that approximate
/// mechanisms have no origins. `nearest` may have fitted origins, and so may a mechanism that explains a file whose
/// systematic deviations are not visible.
std::string falseConvention(const Claim &claim)
{
    std::size_t count = 0;
    for (const ConventionFinding &finding : claim.diagnosis.conventions) {
        const auto &[kind, channels, amount] = static_cast<const Convention &>(finding);
        const bool isOrigin = kind == ZeroPoint;
        if (isOrigin && claim.found.outcome == Outcome::Approximate) {
            return "an origin of an approximate mechanism";
        }
        if (isOrigin && isAngle(channels.front().coordinate) && std::abs(std::remainder(amount, 360.0)) > 179.995) {
            return "an origin that is a half turn";
        }
        const bool mayBeFitted = claim.found.outcome == Outcome::Nearest || claim.file.mayBeApproximate;
        count += kind != WholeTurns && kind != NotDerivative && !(isOrigin && mayBeFitted);
        for (const ClaimColumn &column : claim.file.columns) {
            if (kind == NotDerivative && column.heading == nameOf(channels.front()) && claim.file.truth &&
                column.content != ClaimColumn::Content::Foreign) {
                return column.heading + " is a derivative";
            }
        }
    }
    const bool areTooFew = claim.isIdentified() && count < claim.file.fewestConventions;
    return areTooFew || count > claim.file.mostConventions ? std::to_string(count) + " conventions" : "";
}

/// Checks the crank speeds with a tolerance of 5 %, and the parameter that is said to explain the difference to the
/// given mechanism.
std::string falseChange(const Claim &claim)
{
    const ClaimFile &file = claim.file;
    if (const auto &speeds = claim.diagnosis.unevenCrank) {
        const Values actual = file.exact({Theta2, Order::Velocity}, file.times) / kDegreesPerRadian;
        const auto isNear = [](double speed, double truth) {
            return std::abs(speed - truth) <= 0.05 * std::abs(truth);
        };
        if (!isNear(speeds->atStart, actual[0]) || !isNear(speeds->atEnd, actual.tail(1)[0])) {
            return "the crank does not turn like that";
        }
    }
    const auto &change = claim.diagnosis.change;
    return change && file.wrongGiven &&
                   (change->parameter != *file.wrongGiven ||
                    std::abs(change->value / valueOf(*file.truth, *file.wrongGiven) - 1.0) > 0.01)
               ? "another parameter has changed"
               : "";
}

} // namespace

Claim::Claim(const ClaimFile &claimFile, const ReferenceData &data)
    : file(claimFile)
    , diagnosis(diagnose(data, Mechanism(file.given)))
    , read(data)
{
    for (const ConventionFinding &finding : diagnosis.conventions) {
        read = applied(finding, std::move(read));
    }
}

bool Claim::isIdentified() const
{
    return found.outcome == Outcome::Identified || found.outcome == Outcome::Ambiguous;
}

bool Claim::isUsed(Channel channel) const
{
    return canBeFitted(channel) && std::ranges::count(found.leftOut, channel, &Identification::LeftOut::channel) == 0;
}

std::vector<ParameterError> parameterErrors(const Claim &claim, const Parameters &parameters, const Parameters &truth)
{
    const std::array sizes = parameterSizes(truth);
    std::vector<ParameterError> errors;
    for (const Parameter parameter : kAllParameters) {
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
    const bool isUneven = claim.file.isCrankUneven;
    bool isRight = claim.found.outcome == Outcome::Approximate && claim.file.mayBeApproximate;
    Judgement judgement{claim.found.outcome};
    std::string &why = judgement.falseClaim;
    why = claim.isIdentified() ? falseMechanism(claim, isRight) : "";
    why = why.empty() ? falseConvention(claim) : why;
    why = why.empty() ? falseChange(claim) : why;
    why = why.empty() ? falseDeviation(claim) : why;
    judgement.isDetermined = isUneven || determinesItsMechanism(claim.file);
    judgement.isMissed = judgement.isDetermined && why.empty() && (isUneven ? !claim.diagnosis.unevenCrank : !isRight);
    return judgement;
}

} // namespace slidercrank
