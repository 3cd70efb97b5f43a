// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_judge.h"

#include "core/comparison/comparison.h"
#include "core/mechanism/turn.h"

#include <Eigen/Dense>

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
    Likeness likeness{true, {}};
    std::vector<std::pair<AllChannels, AllChannels>> rows; // truth and image
    for (const double t : file.instants) {
        rows.emplace_back(motionAt(truth, t), motionAt(image, t));
    }
    for (const ClaimColumn &each : file.columns) {
        if (!each.isMotion) {
            continue;
        }
        const std::size_t k = indexOf(each.shown);
        const bool isFree = names(claimed, "zero-point", each.named) || names(claimed, "half-turn", each.named);
        long double size = 0.0L;
        for (const auto &[exact, other] : rows) {
            size = std::isfinite(exact[k]) ? std::max(size, std::abs(exact[k])) : size;
        }
        std::optional<long double> offset;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto &[exact, other] = rows[i];
            if (!std::isfinite(exact[k]) || !std::isfinite(each.values[i])) {
                continue;
            }
            const long double difference = differenceOf(each.shown, other[k], exact[k]);
            if (!offset) {
                offset = isFree ? difference : 0.0L;
            }
            const long double step = each.form.stepAt(each.values[i]) / std::abs(each.factor);
            const long double least = std::max(kSame * size, 0.5L * step);
            if (!(std::abs(differenceOf(each.shown, difference, *offset)) <= least)) {
                return {};
            }
        }
        if (isFree && offset) {
            likeness.offsets.emplace_back(each.named, static_cast<double>(*offset));
        }
    }
    return likeness;
}

/// Half of 0.2 % is no honest aim of a claim; five standard errors are.
constexpr double kLikelyErrors = 5.0;
constexpr double kSmallPart = 2e-3;

/// 0.2 % of each parameter: c of the larger of itself and the crank, θ20 of a radian.
std::array<double, kParameterCount> sizesOf(const Parameters &p)
{
    return {p.a, p.b, std::max(std::abs(p.c), p.a), std::abs(p.omega2), 1.0};
}

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
    result.sizes = sizesOf(truth);
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
        // Standard errors are the mechanism's; a zero point is held to what it can be seen from.
        const auto column = std::ranges::find(file.columns, channel, &ClaimColumn::named);
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const double value : column->values) {
            low = std::min(low, std::isnan(value) ? low : value);
            high = std::max(high, std::isnan(value) ? high : value);
        }
        tolerance = 0.02 * std::max({high - low, std::abs(amount), file.truth ? file.truth->a : 0.0});
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
        const auto same = std::ranges::find_if(
            left, [&](const ExpectedFinding &other) {
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
                                   std::string &why, bool isImage = false)
{
    why = "finds " + described(claim.findings) + " where there is " +
          (file.readings.empty() ? "no slider-crank" : described(file.readings.front().findings));
    for (const TrueReading &reading : file.readings) {
        for (const Parameters &image : imagesOf(reading.truth)) {
            const Likeness likeness = likenessOf(file, reading.truth, image, claim.findings);
            if (!likeness.same || !areSameFindings(file, claim.findings, reading.findings, likeness, isImage)) {
                continue;
            }
            const Offness offness = offnessOf(claim, parameters, image);
            const bool sameBranch = image.branch == parameters.branch;
            if (sameBranch && isNear(offness)) {
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

/// What the file fixes: standard errors of the linearized fit at the truth, zero points free where the kind has them.
struct Fixed {
    std::array<double, kParameterCount> part{}; ///< standard error as part of the parameter's size
    double evidence = 0.0;                      ///< in nats: how unlikely a chance fit is
    double values = 0.0;
    double unknowns = 0.0;
};

bool isAmongNine(Channel channel)
{
    return channel.coordinate == Theta3 || channel.coordinate == R4x ||
           (channel.coordinate == Theta2 && channel.order != Order::Acceleration) ||
           channel == Channel{R4y, Order::Position};
}

Fixed fixedBy(const ClaimFile &file)
{
    const Parameters &truth = *file.truth;
    const std::array<double, kParameterCount> sizes = sizesOf(truth);
    std::vector<const ClaimColumn *> columns;
    std::vector<std::size_t> zeros;
    bool hasLength = false;
    for (const ClaimColumn &each : file.columns) {
        if (each.isMotion && isAmongNine(each.shown)) {
            columns.push_back(&each);
            hasLength = hasLength || !isAngle(each.shown.coordinate);
            if (each.zero != 0.0) {
                zeros.push_back(columns.size() - 1);
            }
        }
    }
    std::vector<Parameter> unknowns{Parameter::B, Parameter::C, Parameter::Omega2, Parameter::Theta20};
    if (hasLength) {
        unknowns.insert(unknowns.begin(), Parameter::A);
    }
    const auto count = static_cast<Eigen::Index>(unknowns.size() + zeros.size());
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    Fixed fixed;
    double logs = 0.0;
    // θ20 is fixed in the middle of the file: far from t = 0 it would go with ω.
    const double middle = 0.5 * (file.instants.front() + file.instants.back());
    std::vector<std::pair<AllChannels, AllChannels>> beside(unknowns.size());
    for (std::size_t row = 0; row < file.instants.size(); ++row) {
        const double t = file.instants[row];
        const double late = 1e-6 / std::abs(truth.omega2);
        const AllChannels before = motionAt(truth, t - late);
        const AllChannels after = motionAt(truth, t + late);
        const AllChannels here = motionAt(truth, t);
        for (std::size_t j = 0; j < unknowns.size(); ++j) {
            constexpr double kStep = 1e-7;
            if (unknowns[j] == Parameter::Omega2) { // ω^k g(ω t + θ20)
                for (std::size_t k = 0; k < kChannelCount; ++k) {
                    const auto order = static_cast<long double>(channelAt(k).order);
                    beside[j].second[k] = order * here[k] + (t - middle) * (after[k] - before[k]) / (2.0L * late);
                }
                continue;
            }
            Parameters less = truth;
            Parameters more = truth;
            valueOf(less, unknowns[j]) -= kStep * sizes[indexOf(unknowns[j])];
            valueOf(more, unknowns[j]) += kStep * sizes[indexOf(unknowns[j])];
            beside[j] = {motionAt(less, t), motionAt(more, t)};
            for (std::size_t k = 0; k < kChannelCount; ++k) {
                beside[j].second[k] =
                    (beside[j].second[k] - beside[j].first[k]) / (2.0L * static_cast<long double>(kStep));
            }
        }
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const ClaimColumn &each = *columns[k];
            const double value = each.values[row];
            if (!std::isfinite(value)) {
                continue;
            }
            const std::size_t channel = indexOf(each.shown);
            const double step = each.form.stepAt(value);
            const double rate = each.factor * static_cast<double>((after[channel] - before[channel]) / (2.0L * late));
            const double blur = std::isfinite(rate) ? rate * file.timeStep : 0.0;
            const double variance = (step * step + blur * blur) / 12.0 + each.noise * each.noise;
            Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
            for (std::size_t j = 0; j < unknowns.size(); ++j) {
                gradient[static_cast<Eigen::Index>(j)] = each.factor * static_cast<double>(beside[j].second[channel]);
            }
            for (std::size_t j = 0; j < zeros.size(); ++j) {
                gradient[static_cast<Eigen::Index>(unknowns.size() + j)] = zeros[j] == k ? 1.0 : 0.0;
            }
            if (!gradient.allFinite()) {
                continue;
            }
            normal += gradient * gradient.transpose() / variance;
            const double spread =
                std::max(std::abs(each.factor) * swingOf(file, each.shown) / std::numbers::sqrt2, step);
            logs += std::log(spread / std::sqrt(kTurn * std::numbers::e * variance));
            fixed.values += 1.0;
        }
    }
    fixed.unknowns = static_cast<double>(count);
    const Eigen::VectorXd scale = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(scaled);
    const Eigen::MatrixXd inverse =
        lu.isInvertible() ? Eigen::MatrixXd(lu.inverse()) : Eigen::MatrixXd::Constant(count, count, kNone);
    const Eigen::MatrixXd covariance = scale.asDiagonal() * inverse * scale.asDiagonal();
    for (std::size_t j = 0; j < unknowns.size(); ++j) {
        const auto at = static_cast<Eigen::Index>(j);
        double variance = covariance(at, at);
        if (unknowns[j] == Parameter::Theta20) { // back to t = 0; ω is the unknown before it, in parts of itself
            const double lever = middle * truth.omega2;
            variance += lever * lever * covariance(at - 1, at - 1) - 2.0 * lever * covariance(at, at - 1);
        }
        fixed.part[indexOf(unknowns[j])] =
            variance >= 0.0 ? std::sqrt(variance) : std::numeric_limits<double>::infinity();
    }
    fixed.evidence = (fixed.values - fixed.unknowns) / std::max(fixed.values, 1.0) * logs;
    return fixed;
}

/// Positions alone at even instants meet other speeds as well; four rows a turn are taken to be enough to tell.
bool hasEnoughRowsATurn(const ClaimFile &file)
{
    constexpr double kRowsATurn = 4.0;
    const auto tells = [](const ClaimColumn &each) {
        return each.shown.coordinate == Theta2 || each.shown.order != Order::Position;
    };
    if (std::ranges::any_of(file.columns, tells)) {
        return true;
    }
    const double turns = std::abs(file.truth->omega2) * (file.instants.back() - file.instants.front()) / kTurn;
    return static_cast<double>(file.instants.size()) > kRowsATurn * turns;
}

bool fixesTheMechanism(const ClaimFile &file)
{
    constexpr double kLargestPart = 0.01;
    constexpr double kLeastEvidence = 40.0; // some more than the program asks for
    constexpr double kFewestOfNoise = 20.0; // rows, of which noise can be told from misfit
    if (!file.truth || file.tooFew || file.mayBeMissed || file.instants.size() < 4 || !hasEnoughRowsATurn(file)) {
        return false;
    }
    const bool noisy = std::ranges::any_of(file.columns, [](const ClaimColumn &each) { return each.noise > 0.0; });
    const Fixed fixed = fixedBy(file);
    return std::ranges::all_of(fixed.part, [](double part) { return part < kLargestPart; }) &&
           fixed.values >= 2.0 * fixed.unknowns && fixed.evidence >= kLeastEvidence &&
           (!noisy || static_cast<double>(file.instants.size()) >= kFewestOfNoise);
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
        double peak = 1e-9 * naturalScale(Mechanism(model), verdict.channel);
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
                    static_cast<double>(std::abs(motionAt(model, t + late * file.timeStep)[k] - value));
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
        if (right && !std::ranges::all_of(claim.images, isTrueImage)) {
            return "an image that " + other;
        }
        if (claim.outcome == ClaimedOutcome::Ambiguous && !right) {
            right = std::ranges::any_of(claim.images, isTrue) || std::ranges::any_of(claim.alternatives, isTrue);
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
        return "an uneven crank, from " + std::to_string((*claim.crankSpeeds)[0]) + " to " +
               std::to_string((*claim.crankSpeeds)[1]) + " rad/s, that is another";
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
    for (const Parameters &image : imagesOf(*file.truth)) {
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
