// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_judge.h"

#include "core/comparison/comparison.h"
#include "core/mechanism/turn.h"
#include "tests/support/what_is_fixed.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace slidercrank
{

namespace
{

std::string described(const Parameters &p)
{
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), "a %.9g b %.9g c %.9g omega2 %.9g theta20 %.9g %s", p.a, p.b, p.c, p.omega2,
                  p.theta20, p.branch == Branch::Open ? "open" : "crossed");
    return text.data();
}

std::string described(const std::vector<ExpectedFinding> &findings)
{
    std::string text;
    for (const ExpectedFinding &finding : findings) {
        text += (text.empty() ? "" : ", ") + std::string(finding.name);
        for (const Channel channel : finding.channels) {
            text += ' ' + std::string(nameOf(channel));
        }
        text += ' ' + std::to_string(finding.amount);
    }
    return text.empty() ? "nothing" : text;
}

long double differenceOf(Channel channel, long double one, long double other)
{
    const long double difference = one - other;
    const bool angle = isAngle(channel.coordinate) && channel.order == Order::Position;
    return angle ? std::remainder(difference, 360.0L) : difference;
}

/// How an image of the truth would read in the file's columns.
struct Likeness {
    bool same = false;
    std::vector<std::pair<Channel, double>> offsets; ///< image less truth, of columns with a free zero
};

bool names(const std::vector<ExpectedFinding> &findings, std::string_view name, Channel channel)
{
    return std::ranges::any_of(findings, [&](const ExpectedFinding &finding) {
        return finding.name == name && std::ranges::count(finding.channels, channel) > 0;
    });
}

/// Whether no column of the file tells the image from the truth, to half a printed step; columns whose zero the claim
/// takes to be free, up to a constant.
Likeness likenessOf(const ClaimFile &file, const Parameters &truth, const Parameters &image,
                    const std::vector<ExpectedFinding> &claimed)
{
    constexpr long double kSame = 1e-9L; // of the channel's size
    struct Compared {
        const ClaimColumn &column;
        bool isFree;
        long double size;
        std::optional<long double> offset{};
    };
    std::vector<Compared> compared;
    for (const ClaimColumn &each : file.columns) {
        if (each.isMotion) {
            double size = 0.0;
            for (const double value : each.values) {
                size = std::isfinite(value) ? std::max(size, std::abs(value - each.zero)) : size;
            }
            const bool isFree = names(claimed, "zero-point", each.named) || names(claimed, "half-turn", each.named);
            compared.push_back({each, isFree, size / std::abs(each.factor)});
        }
    }
    for (std::size_t i = 0; i < file.instants.size(); ++i) {
        const AllChannels exact = motionAt(truth, file.instants[i]);
        const AllChannels other = motionAt(image, file.instants[i]);
        for (auto &[each, isFree, size, offset] : compared) {
            const std::size_t k = indexOf(each.shown);
            if (!std::isfinite(exact[k]) || !std::isfinite(each.values[i])) {
                continue;
            }
            const long double difference = differenceOf(each.shown, other[k], exact[k]);
            if (!offset) {
                offset = isFree ? difference : 0.0L;
            }
            const long double step = each.form.stepAt(each.values[i]) / std::abs(each.factor);
            if (!(std::abs(differenceOf(each.shown, difference, *offset)) <= std::max(kSame * size, 0.5L * step))) {
                return {};
            }
        }
    }
    Likeness likeness{true, {}};
    for (const auto &[each, isFree, size, offset] : compared) {
        if (isFree && offset) {
            likeness.offsets.emplace_back(each.named, static_cast<double>(*offset));
        }
    }
    return likeness;
}

/// Half of 0.2 % is no honest aim of a claim; five standard errors are.
constexpr double kLikelyErrors = 5.0;
constexpr double kSmallPart = 2e-3;

struct Offness {
    std::array<double, kParameterCount> off{};   ///< claimed less true
    std::array<double, kParameterCount> error{}; ///< standard errors
    std::array<bool, kParameterCount> counts{};
    std::array<double, kParameterCount> sizes{};
};

Offness offnessOf(const ProgramClaim &claim, const Parameters &parameters, const Parameters &truth)
{
    Offness result;
    result.error = claim.standardError;
    result.counts = claim.identifiable;
    result.sizes = partSizes(truth);
    double scale = 1.0;
    if (claim.onlyRatios) { // b and c go with the a that was given
        scale = parameters.a / truth.a;
        result.counts[indexOf(Parameter::A)] = false;
        result.counts[indexOf(Parameter::B)] = result.counts[indexOf(Parameter::C)] = true;
    }
    result.sizes[0] *= scale;
    result.sizes[1] *= scale;
    result.sizes[2] *= scale;
    result.off = {parameters.a - scale * truth.a, parameters.b - scale * truth.b, parameters.c - scale * truth.c,
                  parameters.omega2 - truth.omega2, std::remainder(parameters.theta20 - truth.theta20, kTurn)};
    return result;
}

bool isNear(const Offness &offness, double errors = kLikelyErrors)
{
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        const double error = std::isfinite(offness.error[i]) ? offness.error[i] : 0.0;
        if (offness.counts[i] &&
            !(std::abs(offness.off[i]) <= std::max(errors * error, kSmallPart * offness.sizes[i]))) {
            return false;
        }
    }
    return true;
}

bool isWithin(const Offness &offness, double part)
{
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        if (offness.counts[i] && !(std::abs(offness.off[i]) <= part * offness.sizes[i])) {
            return false;
        }
    }
    return true;
}

bool isSameFinding(const ClaimFile &file, const ExpectedFinding &claimed, const ExpectedFinding &expected,
                   const Likeness &likeness)
{
    std::vector<Channel> one = claimed.channels;
    std::vector<Channel> other = expected.channels;
    std::ranges::sort(one, {}, [](Channel channel) { return indexOf(channel); });
    std::ranges::sort(other, {}, [](Channel channel) { return indexOf(channel); });
    if (claimed.name != expected.name || (one != other && claimed.name != "time-unit" && claimed.name != "axis")) {
        return false;
    }
    if (expected.amount == 0.0) {
        return true;
    }
    double amount = expected.amount;
    double tolerance = 1e-9 * std::abs(amount);
    if (claimed.name == "zero-point") {
        const Channel channel = claimed.channels.front();
        for (const auto &[which, offset] : likeness.offsets) {
            amount += which == channel ? offset : 0.0;
        }
        double error = 0.0;
        const WhatIsFixed fixed = file.truth ? whatIsFixed(file) : WhatIsFixed();
        for (const auto &[which, zeroError] : fixed.zeroErrors) {
            error = which == channel ? zeroError : error;
        }
        const double size = isAngle(channel.coordinate) ? kDegreesPerRadian : file.truth ? file.truth->a : 0.0;
        tolerance = std::max(kLikelyErrors * error, kSmallPart * std::max(std::abs(amount), size));
        const double difference = claimed.amount - amount;
        return std::abs(isAngle(channel.coordinate) ? std::remainder(difference, 360.0) : difference) <= tolerance;
    }
    return std::abs(claimed.amount - amount) <= tolerance;
}

/// Whole turns change nothing that is claimed: θ3 is taken up to them.
/// Of an image that is named beside the claim, a zero point is another one, of which nothing is said.
bool areSameFindings(const ClaimFile &file, const std::vector<ExpectedFinding> &claimed,
                     const std::vector<ExpectedFinding> &expected, const Likeness &likeness, bool isImage)
{
    std::vector<ExpectedFinding> left = expected;
    for (const ExpectedFinding &one : claimed) {
        if (one.name == "whole-turns") {
            continue;
        }
        const auto same = std::ranges::find_if(left, [&](const ExpectedFinding &other) {
            return (isImage && one.name == "zero-point" && one.name == other.name && one.channels == other.channels) ||
                   isSameFinding(file, one, other, likeness);
        });
        if (same == left.end()) {
            return false;
        }
        left.erase(same);
    }
    return left.empty();
}

/// The true reading that a mechanism with the claim's findings is, if any; else what is wrong.
std::optional<Offness> trueReading(const ClaimFile &file, const ProgramClaim &claim, const Parameters &parameters,
                                   std::string &why, bool isImage = false, bool isAlternative = false)
{
    why = "finds " + described(claim.findings) + " where there is " +
          (file.readings.empty() ? "no slider-crank" : described(file.readings.front().findings));
    for (const TrueReading &reading : file.readings) {
        for (const Parameters &image : mirrorImages(reading.truth)) {
            const Likeness likeness = likenessOf(file, reading.truth, image, claim.findings);
            // How the file would read with an alternative is not said.
            if (!likeness.same ||
                (!isAlternative && !areSameFindings(file, claim.findings, reading.findings, likeness, isImage))) {
                continue;
            }
            const Offness offness = offnessOf(claim, parameters, image);
            const bool sameBranch = image.branch == parameters.branch;
            // The standard errors are those of the first; of an alternative there are none.
            constexpr double kAboutRight = 0.05;
            if (sameBranch && (isNear(offness) || (isAlternative && isWithin(offness, kAboutRight)))) {
                return offness;
            }
            if (why.starts_with("finds")) {
                why = "is " + described(parameters) + ", not " + described(image) + " ±";
                for (const double error : claim.standardError) {
                    why += ' ' + std::to_string(error);
                }
            }
        }
    }
    return std::nullopt;
}

/// A verdict better than `differs` for a motion that is off by more than 2 % of its peak beyond half the printed step.
std::string falseVerdict(const ClaimFile &file, const ReferenceData &read,
                         const std::vector<ChannelComparison> &verdicts, const Parameters &model,
                         const std::vector<ExpectedFinding> &findings)
{
    constexpr double kVisible = 0.02;
    for (const ChannelComparison &verdict : verdicts) {
        const ReferenceSeries *series = read.find(verdict.channel);
        const auto column = std::ranges::find(file.columns, verdict.channel, &ClaimColumn::named);
        if (verdict.verdict == Verdict::Differs || series == nullptr ||
            names(findings, "swapped-columns", verdict.channel)) {
            continue;
        }
        double factor = 1.0;
        for (const ExpectedFinding &finding : findings) {
            if (finding.name.ends_with("-unit") && names({finding}, finding.name, verdict.channel)) {
                factor *= finding.amount;
            }
        }
        double peak = 1e-9 * toFileUnit(verdict.channel, naturalSize(model, verdict.channel));
        double excess = 0.0;
        const std::size_t k = indexOf(verdict.channel);
        for (std::size_t i = 0; i < read.time.size(); ++i) {
            const double value = series->values[i];
            if (!std::isfinite(value)) {
                continue;
            }
            const double t = read.time[i];
            const double off = static_cast<double>(std::abs(motionAt(model, t)[k] - value));
            peak = std::max(peak, static_cast<double>(std::abs(motionAt(model, t)[k])));
            double least = off;
            for (const double late : {-0.5, 0.5}) { // times the step of the clock
                const double other =
                    static_cast<double>(std::abs(motionAt(model, t + late * file.timeStep * file.clock)[k] - value));
                least = std::min(least, other);
            }
            excess = std::max(excess, least - 0.5 * column->form.stepAt(value / factor) * std::abs(factor));
        }
        if (excess > kVisible * peak) {
            return std::string(verdict.verdict == Verdict::Agrees ? "agrees" : "close") + " in " +
                   std::string(nameOf(verdict.channel)) + ", which is off by " + std::to_string(100.0 * excess / peak) +
                   " % of the peak, with " + described(model);
        }
    }
    return {};
}

/// Whether the columns stand there as the motion has them, but for rounding.
bool isPlain(const ClaimFile &file)
{
    return file.truth && file.clock == 1.0 && std::ranges::all_of(file.columns, [](const ClaimColumn &each) {
               return each.isMotion && each.named == each.shown && each.factor == 1.0 && each.zero == 0.0 &&
                      each.noise == 0.0;
           });
}

bool isNear(const std::array<double, 2> &claimed, const std::optional<std::array<double, 2>> &speeds)
{
    constexpr double kNear = 0.05;
    return speeds && std::abs(claimed[0] - (*speeds)[0]) <= kNear * std::abs((*speeds)[0]) &&
           std::abs(claimed[1] - (*speeds)[1]) <= kNear * std::abs((*speeds)[1]);
}

std::string falseClaim(const ClaimFile &file, const ReferenceData &data, const ProgramClaim &claim, bool &right)
{
    right = false;
    std::string why;
    const bool claims = claim.outcome == ClaimedOutcome::Identified || claim.outcome == ClaimedOutcome::Ambiguous;
    if (claims && file.tooFew) {
        return "identified from next to nothing";
    }
    if (claims) {
        right = trueReading(file, claim, claim.parameters, why).has_value();
        std::string other;
        const auto isTrue = [&](const Parameters &parameters) {
            return trueReading(file, claim, parameters, other).has_value();
        };
        const auto isTrueImage = [&](const Parameters &parameters) {
            return trueReading(file, claim, parameters, other, true).has_value();
        };
        const auto isTrueAlternative = [&](const Parameters &parameters) {
            return trueReading(file, claim, parameters, other, false, true).has_value();
        };
        if (right && !std::ranges::all_of(claim.images, isTrueImage)) {
            return "an image that " + other;
        }
        if (claim.outcome == ClaimedOutcome::Ambiguous && !right) {
            right =
                std::ranges::any_of(claim.images, isTrue) || std::ranges::any_of(claim.alternatives, isTrueAlternative);
        }
        if (!right) {
            return why;
        }
        if (claim.outcome == ClaimedOutcome::Identified && !trueReading(file, claim, claim.rounded, why)) {
            return "rounded " + why;
        }
    } else if (!claim.findings.empty()) {
        Likeness plain{true, {}};
        const auto isTrue = [&](const TrueReading &reading) {
            return areSameFindings(file, claim.findings, reading.findings, plain, false);
        };
        if (std::ranges::none_of(file.readings, isTrue)) {
            return "finds " + described(claim.findings) + " without a mechanism";
        }
    }
    if (claim.crankSpeeds && !isNear(*claim.crankSpeeds, file.crankSpeeds)) {
        const std::array<double, 2> speeds = file.crankSpeeds.value_or(std::array{kNone, kNone});
        return "an uneven crank, from " + std::to_string((*claim.crankSpeeds)[0]) + " to " +
               std::to_string((*claim.crankSpeeds)[1]) + " rad/s, not from " + std::to_string(speeds[0]) + " to " +
               std::to_string(speeds[1]);
    }
    if (claim.change && file.offBy &&
        (claim.change != file.offBy || std::abs(claim.changed / valueOf(*file.truth, *file.offBy) - 1.0) > 0.01)) {
        return "another parameter is said to have changed";
    }
    if (std::string wrong = falseVerdict(file, claim.read, claim.identified, claim.parameters, claim.findings);
        !wrong.empty()) {
        return wrong;
    }
    const ExactComparison hand = compareExactly(Mechanism(file.atHand), data);
    if (std::string wrong = falseVerdict(file, data, hand.channels, file.atHand, {}); !wrong.empty()) {
        return wrong;
    }
    if (isPlain(file)) {
        for (const ChannelComparison &channel : compareExactly(Mechanism(*file.truth), data).channels) {
            if (channel.verdict == Verdict::Differs) {
                return "differs in " + std::string(nameOf(channel.channel)) + " from its own motion, by " +
                       std::to_string(channel.worstOver) + " half steps";
            }
        }
    }
    return {};
}

} // namespace

std::vector<double> standardErrorsOff(const ClaimFile &file, const ProgramClaim &claim)
{
    std::vector<double> result;
    double least = std::numeric_limits<double>::infinity();
    for (const Parameters &image : mirrorImages(*file.truth)) {
        if (claim.outcome != ClaimedOutcome::Identified || image.branch != claim.parameters.branch ||
            !likenessOf(file, *file.truth, image, claim.findings).same) {
            continue;
        }
        const Offness offness = offnessOf(claim, claim.parameters, image);
        std::vector<double> ratios;
        double sum = 0.0;
        for (std::size_t i = 0; i < kParameterCount; ++i) {
            if (offness.counts[i]) {
                ratios.push_back(std::abs(offness.off[i]) / offness.error[i]);
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

ClaimJudgement judged(const ClaimFile &file, const ReferenceData &data)
{
    const ProgramClaim claim = claimOf(data, Mechanism(file.atHand));
    ClaimJudgement judgement;
    judgement.outcome = claim.outcome;
    judgement.falseClaim = falseClaim(file, data, claim, judgement.right);
    judgement.fixes = fixesTheMechanism(file);
    if (judgement.fixes && !judgement.right && judgement.falseClaim.empty()) {
        judgement.miss = "missed " + described(*file.truth);
    }
    if (file.crankSpeeds) {
        judgement.fixes = true;
        judgement.miss = claim.crankSpeeds ? "" : "does not say that the crank turns unevenly";
    }
    return judgement;
}

} // namespace slidercrank
