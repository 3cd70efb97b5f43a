// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_judge.h"

#include "core/mechanism/turn.h"
#include "tests/support/claim_deviation.h"
#include "tests/support/expected_precision.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr double kStandardErrors = 5.0; ///< largest accepted error of a claimed parameter
constexpr double kOriginTolerance = 2e-3;

std::string describe(const Parameters &p)
{
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), "a %.9g b %.9g c %.9g omega2 %.9g theta20 %.9g %s", p.a, p.b, p.c, p.omega2,
                  p.theta20, p.branch == Branch::Open ? "open" : "crossed");
    return text.data();
}

template <class SomeFinding>
std::string describe(const std::vector<SomeFinding> &findings)
{
    std::string text;
    for (const Finding &finding : findings) {
        text += (text.empty() ? "" : ", ") + std::string(finding.name);
        for (const Channel channel : finding.channels) {
            text += ' ' + std::string(nameOf(channel));
        }
        text += ' ' + std::to_string(finding.amount);
    }
    return text.empty() ? "nothing" : text;
}

Pose poseInRow(const ClaimFile &file, const Parameters &parameters, std::size_t row)
{
    const double t = file.instants[row];
    return file.byAngle ? poseAt(parameters, file.truth->omega2 * t + file.truth->theta20, file.truth->omega2)
                        : motionAt(parameters, t);
}

/// Result of comparing an image of the truth with the truth in the file's columns.
struct Likeness {
    bool isSame = false;                               ///< no column distinguishes the image from the truth
    std::vector<std::pair<Channel, double>> offsets{}; ///< image minus truth, for columns with a free origin
};

/// Compares with a tolerance of half a rounding step; columns whose origin the claim treats as free, up to a constant.
Likeness compareImage(const ClaimFile &file, const Parameters &truth, const Parameters &image,
                      const ProgramClaim &claim)
{
    constexpr long double kSame = 1e-9L; // of the channel's size
    Likeness likeness{true};
    for (const ClaimColumn &column : file.columns) {
        if (column.content != ClaimColumn::Content::Motion) {
            continue;
        }
        double size = 0.0;
        for (const double value : column.values) {
            size = std::isfinite(value) ? std::max(size, std::abs(value - column.origin)) : size;
        }
        const long double factor = std::abs(column.factor);
        const std::size_t k = indexOf(column.shown);
        const bool isFree =
            hasFinding(claim, "zero-point", column.named) || hasFinding(claim, "half-turn", column.named);
        std::optional<long double> offset;
        for (std::size_t row = 0; row < file.instants.size(); ++row) {
            const long double exact = poseInRow(file, truth, row)[k];
            if (!std::isfinite(exact) || !std::isfinite(column.values[row])) {
                continue;
            }
            const long double difference = differenceIn(column.shown, poseInRow(file, image, row)[k], exact);
            offset = offset.value_or(isFree ? difference : 0.0L);
            const long double tolerance =
                std::max(kSame * size / factor, 0.5L * column.form.stepAt(column.values[row]) / factor);
            if (!(std::abs(differenceIn(column.shown, difference, *offset)) <= tolerance)) {
                return {};
            }
        }
        if (isFree && offset) {
            likeness.offsets.emplace_back(column.named, static_cast<double>(*offset));
        }
    }
    return likeness;
}

struct ParameterErrors {
    std::array<double, kParameterCount> difference{}; ///< claimed minus true
    std::array<double, kParameterCount> standardError{};
    std::array<bool, kParameterCount> counts{};
    std::array<double, kParameterCount> sizes{};

    bool areWithin(double standardErrors, double part) const
    {
        for (std::size_t i = 0; i < kParameterCount; ++i) {
            const double error = std::isfinite(standardError[i]) ? standardError[i] : 0.0;
            if (counts[i] && !(std::abs(difference[i]) <= std::max(standardErrors * error, part * sizes[i]))) {
                return false;
            }
        }
        return true;
    }
};

ParameterErrors parameterErrors(const ProgramClaim &claim, const Parameters &parameters, const Parameters &truth)
{
    ParameterErrors errors;
    errors.standardError = claim.standardError;
    errors.counts = claim.identifiable;
    errors.sizes = parameterSizes(truth);
    double scale = 1.0;
    if (claim.onlyRatios) { // b and c scale with the given a
        scale = parameters.a / truth.a;
        errors.counts[indexOf(Parameter::A)] = false;
        errors.counts[indexOf(Parameter::B)] = errors.counts[indexOf(Parameter::C)] = true;
    }
    for (const Parameter length : {Parameter::A, Parameter::B, Parameter::C}) {
        errors.sizes[indexOf(length)] *= scale;
        errors.difference[indexOf(length)] = valueOf(parameters, length) - scale * valueOf(truth, length);
    }
    errors.difference[indexOf(Parameter::Omega2)] = parameters.omega2 - truth.omega2;
    errors.difference[indexOf(Parameter::Theta20)] = std::remainder(parameters.theta20 - truth.theta20, kTurn);
    return errors;
}

Channels sorted(Channels channels)
{
    std::ranges::sort(channels, {}, [](Channel channel) { return indexOf(channel); });
    return channels;
}

bool isSameOrigin(const ClaimFile &file, const Finding &claimed, double amount, const Likeness &likeness)
{
    const Channel channel = claimed.channels.front();
    for (const auto &[shifted, offset] : likeness.offsets) {
        amount += shifted == channel ? offset : 0.0;
    }
    double error = 0.0;
    if (file.truth) {
        for (const auto &[shifted, originError] : expectedPrecision(file).originErrors) {
            error = shifted == channel ? originError : error;
        }
    }
    const double size = isAngle(channel.coordinate) ? kDegreesPerRadian : file.truth ? file.truth->a : 0.0;
    const double difference = claimed.amount - amount;
    return std::abs(isAngle(channel.coordinate) ? std::remainder(difference, 360.0) : difference) <=
           std::max(kStandardErrors * error, kOriginTolerance * std::max(std::abs(amount), size));
}

bool isSameFinding(const ClaimFile &file, const Finding &claimed, const Finding &expected, const Likeness &likeness)
{
    const bool isOfTheWholeFile = claimed.name == "time-unit" || claimed.name == "axis";
    const Channels channels = sorted(claimed.channels);
    const Channels trueChannels = sorted(expected.channels);
    const bool areChannelsTrue =
        channels == trueChannels || (expected.isOptional && std::ranges::all_of(channels, [&](Channel channel) {
                                         return std::ranges::count(trueChannels, channel) > 0;
                                     }));
    if (claimed.name != expected.name || (!isOfTheWholeFile && !areChannelsTrue)) {
        return false;
    }
    if (expected.amount != 0.0 && claimed.name == "zero-point") {
        return isSameOrigin(file, claimed, expected.amount, likeness);
    }
    return expected.amount == 0.0 || std::abs(claimed.amount - expected.amount) <= 1e-9 * std::abs(expected.amount);
}

/// The mechanism of a claim, one of its images (whose origins are not reported), or one of its alternatives (which may
/// interpret the file in another way and have no standard errors).
enum class Role { Mechanism, Image, Alternative };

/// Returns whether the claim states the expected findings. Ignores whole turns. A column that is listed as left out
/// need not also be reported as "not-derivative".
bool areSameFindings(const ClaimFile &file, const ProgramClaim &claim, const std::vector<Finding> &expected,
                     const Likeness &likeness, Role role)
{
    std::vector<Finding> missing = expected;
    for (const Finding &finding : claim.findings) {
        const auto same = std::ranges::find_if(missing, [&](const Finding &other) {
            return (role == Role::Image && finding.name == "zero-point" && finding.name == other.name &&
                    finding.channels == other.channels) ||
                   isSameFinding(file, finding, other, likeness);
        });
        if (same == missing.end() && finding.name != "whole-turns") {
            return false;
        }
        if (same != missing.end() && !same->isOptional) {
            missing.erase(same);
        }
    }
    return std::ranges::all_of(missing, [&](const Finding &finding) {
        return finding.isOptional ||
               (finding.name == "not-derivative" &&
                std::ranges::all_of(finding.channels, [&](Channel channel) { return isLeftOut(claim, channel); }));
    });
}

/// Explains why a mechanism with the claim's findings is not a true interpretation. Empty if it is one.
std::string falseMechanism(const ClaimFile &file, const ProgramClaim &claim, const Parameters &parameters,
                           Role role = Role::Mechanism)
{
    std::string why = "finds " + describe(claim.findings) + " where there is " +
                      (file.interpretations.empty() ? "no slider-crank" : describe(file.interpretations[0].findings));
    for (const ExpectedInterpretation &interpretation : file.interpretations) {
        for (const Parameters &image : mirrorImages(interpretation.mechanism)) {
            const Likeness likeness = compareImage(file, interpretation.mechanism, image, claim);
            if (!likeness.isSame ||
                (role != Role::Alternative && !areSameFindings(file, claim, interpretation.findings, likeness, role))) {
                continue;
            }
            const ParameterErrors errors = parameterErrors(claim, parameters, image);
            constexpr double kRoughly = 0.05;
            const bool isNear = errors.areWithin(kStandardErrors, file.tolerance) ||
                                (role == Role::Alternative && errors.areWithin(0.0, kRoughly));
            if (isNear && image.branch == parameters.branch) {
                return {};
            }
            if (why.starts_with("finds")) {
                why = "is " + describe(parameters) + ", not " + describe(image) + " ±";
                for (const double error : claim.standardError) {
                    why += ' ' + std::to_string(error);
                }
            }
        }
    }
    return why;
}

/// Explains which claimed mechanism is false. Sets `isRight` if the claim contains the truth as its mechanism or in its
/// list.
std::string falseMechanisms(const ClaimFile &file, const ProgramClaim &claim, bool &isRight)
{
    if (file.hasTooFewValues) {
        return "identified from next to nothing";
    }
    const std::string why = falseMechanism(file, claim, claim.parameters);
    isRight = why.empty();
    const auto isTrue = [&](Role role) {
        return [&file, &claim, role](const Parameters &p) { return falseMechanism(file, claim, p, role).empty(); };
    };
    for (const Parameters &image : claim.images) {
        if (std::string wrong = falseMechanism(file, claim, image, Role::Image); isRight && !wrong.empty()) {
            return "an image that " + wrong;
        }
    }
    if (claim.outcome == ClaimedOutcome::Ambiguous) {
        isRight = isRight || std::ranges::any_of(claim.images, isTrue(Role::Mechanism)) ||
                  std::ranges::any_of(claim.alternatives, isTrue(Role::Alternative));
        return isRight ? "" : why;
    }
    const std::string wrong = falseMechanism(file, claim, claim.rounded);
    return !isRight ? why : wrong.empty() ? "" : "rounded " + wrong;
}

/// Checks the findings of a claim without an identified mechanism. They must be those of a true interpretation, except
/// that `nearest` may state fitted origins. An approximate mechanism may omit findings and must not state origins.
std::string falseFindings(const ClaimFile &file, const ProgramClaim &claim)
{
    const bool isApproximate = claim.outcome == ClaimedOutcome::Approximate;
    if (claim.outcome == ClaimedOutcome::Nearest &&
        std::ranges::all_of(claim.findings, [](const Finding &finding) { return finding.name == "zero-point"; })) {
        return {};
    }
    const auto isTrue = [&](const ExpectedInterpretation &interpretation) {
        const auto isExpected = [&](const Finding &finding) {
            return finding.name == "whole-turns" ||
                   std::ranges::any_of(interpretation.findings, [&](const Finding &expected) {
                       return isSameFinding(file, finding, expected, {true});
                   });
        };
        return isApproximate ? std::ranges::all_of(claim.findings, isExpected)
                             : areSameFindings(file, claim, interpretation.findings, {true}, Role::Mechanism);
    };
    if (!claim.findings.empty() && std::ranges::none_of(file.interpretations, isTrue)) {
        return "finds " + describe(claim.findings) + " without an exact mechanism";
    }
    for (const Finding &finding : claim.findings) {
        if (isApproximate && finding.name == "zero-point") {
            return "an origin beside an approximate mechanism";
        }
    }
    return {};
}

/// Checks the claimed crank speeds with a tolerance of 5 %.
std::string falseCrankSpeeds(const ClaimFile &file, const ProgramClaim &claim)
{
    if (!claim.crankSpeeds) {
        return {};
    }
    const std::array claimed = *claim.crankSpeeds;
    const std::array speeds = file.crankSpeeds.value_or(std::array{kNone, kNone});
    const auto isNear = [](double one, double other, double part) {
        return std::abs(one - other) <= part * std::abs(other);
    };
    if (isNear(claimed[0], speeds[0], 0.05) && isNear(claimed[1], speeds[1], 0.05)) {
        return {};
    }
    return "an uneven crank, from " + std::to_string(claimed[0]) + " to " + std::to_string(claimed[1]) +
           " rad/s, not from " + std::to_string(speeds[0]) + " to " + std::to_string(speeds[1]);
}

std::string falseClaim(const ClaimFile &file, const ReferenceData &data, const ProgramClaim &claim, bool &isRight)
{
    const bool isIdentified = claim.outcome == ClaimedOutcome::Identified || claim.outcome == ClaimedOutcome::Ambiguous;
    isRight = claim.outcome == ClaimedOutcome::Approximate && file.mayBeApproximate;
    std::string wrong = isIdentified ? falseMechanisms(file, claim, isRight) : falseFindings(file, claim);
    if (wrong.empty()) {
        wrong = falseCrankSpeeds(file, claim);
    }
    if (wrong.empty() && claim.change && file.wrongGiven &&
        (claim.change != file.wrongGiven ||
         std::abs(claim.changedValue / valueOf(*file.truth, *file.wrongGiven) - 1.0) > 0.01)) {
        wrong = "another parameter is said to have changed";
    }
    return wrong.empty() ? falseDeviation(file, data, claim) : wrong;
}

} // namespace

std::vector<double> errorsInStandardErrors(const ClaimFile &file, const ProgramClaim &claim)
{
    std::vector<double> result;
    double least = std::numeric_limits<double>::infinity();
    for (const Parameters &image : mirrorImages(*file.truth)) {
        if (claim.outcome != ClaimedOutcome::Identified || image.branch != claim.parameters.branch ||
            !compareImage(file, *file.truth, image, claim).isSame) {
            continue;
        }
        const ParameterErrors errors = parameterErrors(claim, claim.parameters, image);
        std::vector<double> ratios;
        double sum = 0.0;
        for (std::size_t i = 0; i < kParameterCount; ++i) {
            if (errors.counts[i]) {
                ratios.push_back(std::abs(errors.difference[i]) / errors.standardError[i]);
                sum += ratios.back();
            }
        }
        if (sum < least) {
            least = sum;
            result = ratios;
        }
    }
    return result;
}

ClaimJudgement judgeClaim(const ClaimFile &file, const ReferenceData &data, const ProgramClaim &claim)
{
    ClaimJudgement judgement{claim.outcome};
    judgement.falseClaim = falseClaim(file, data, claim, judgement.isRight);
    judgement.isDetermined = file.crankSpeeds || determinesItsMechanism(file);
    if (file.crankSpeeds) {
        judgement.miss = claim.crankSpeeds ? "" : "does not say that the crank turns unevenly";
    } else if (judgement.isDetermined && !judgement.isRight && judgement.falseClaim.empty()) {
        judgement.miss = "missed " + describe(*file.truth);
    }
    return judgement;
}

} // namespace slidercrank
