// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/candidate_search.h"

#include "core/identification/interpretation.h"
#include "core/identification/shape_search.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

bool isPlottedDerivative(Channel channel)
{
    return channel.order != Order::Position && (channel.coordinate == R4x || channel.coordinate == Theta3);
}

/// A copy of a hypothesis whose offsets and scales have to be fitted anew.
Hypothesis restarted(const Hypothesis &hypothesis)
{
    Hypothesis result = hypothesis;
    result.unknowns.conservativeResize(static_cast<Eigen::Index>(kParameterCount));
    return result;
}

bool isSame(const Hypothesis &x, const Hypothesis &y)
{
    return x.timeUnit == y.timeUnit && x.columns == y.columns && x.abscissaFactor == y.abscissaFactor &&
           x.isFree == y.isFree && x.isBalanced == y.isBalanced && areNear(middleParameters(x), middleParameters(y));
}

/// Whether two hypotheses differ only by an image of the mechanism with the signs and half turns that belong to it.
bool isImage(const Hypothesis &x, const Hypothesis &y)
{
    const auto isAlike = [](const ColumnUse &one, const ColumnUse &other) {
        return one.channel == other.channel && one.unit == other.unit && one.isUsed == other.isUsed &&
               one.hasOffset == other.hasOffset;
    };
    return x.timeUnit == y.timeUnit && std::abs(x.abscissaFactor) == std::abs(y.abscissaFactor) &&
           x.isFree == y.isFree && std::ranges::equal(x.columns, y.columns, isAlike) &&
           std::ranges::any_of(mirrorImages(middleParameters(x)),
                               [&](const Parameters &image) { return areNear(image, middleParameters(y)); });
}

bool isKnown(const Hypothesis &hypothesis, const std::vector<Candidate> &all)
{
    return std::ranges::any_of(
        all, [&](const Candidate &candidate) { return isSame(candidate.fit.hypothesis, hypothesis); });
}

void addWithVariants(const Observations &data, Hypothesis hypothesis, std::vector<Candidate> &all);

/// Adds variants of the candidate without those free origins that were fitted to nearly zero.
void addWithoutIdleOffsets(const Observations &data, const Candidate &candidate, std::vector<Candidate> &all)
{
    constexpr double kIdlePart = 2e-2; // of the spread, of the crank's length for R4y, of a radian for θ2
    const Hypothesis &fitted = candidate.fit.hypothesis;
    const UnknownLayout layout(fitted.columns);
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        const ObservedColumn &column = data.columns[j];
        const double size = column.channel.coordinate == R4y ? std::abs(fitted.unknowns[0]) : column.spread;
        if (layout.offset[j] >= 0 &&
            std::abs(fitted.unknowns[layout.offset[j]]) < std::max(kIdlePart * size, column.step)) {
            Hypothesis without = restarted(fitted);
            without.columns[j].hasOffset = false;
            addWithVariants(data, std::move(without), all);
        }
    }
    const double plainAngle = fitted.abscissaFactor * data.origin;
    const double zero = std::remainder(fitted.unknowns[4] - plainAngle, 2.0 * std::numbers::pi);
    if (data.isByCrankAngle && fitted.isFree[indexOf(Parameter::Theta20)] && std::abs(zero) < kIdlePart) {
        Hypothesis without = restarted(fitted);
        without.isFree[indexOf(Parameter::Theta20)] = false;
        without.unknowns[4] = plainAngle;
        addWithVariants(data, std::move(without), all);
    }
}

/// The used columns whose residuals are as bad as `least` or worse.
std::vector<std::size_t> failingColumns(const Candidate &candidate, Residual least)
{
    std::vector<std::size_t> failing;
    for (std::size_t j = 0; j < candidate.residuals.size(); ++j) {
        if (candidate.residuals[j] >= least && candidate.residuals[j] != Residual::NotUsed) {
            failing.push_back(j);
        }
    }
    return failing;
}

/// Whether a column deviates as differences of the positions do: by little, or by noise that is no function of the
/// crank angle.
bool mayBeDifference(const Observations &data, const Candidate &candidate, const std::vector<double> &angles,
                     std::size_t j)
{
    const double spread = data.columns[j].spread * std::abs(candidate.fit.hypothesis.columns[j].factor());
    if (std::sqrt(candidate.fit.noiseVariances[j]) <= kLargestDifferencePart * spread) {
        return true;
    }
    std::vector<double> residuals;
    std::vector<double> residualAngles;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        if (const double residual = candidate.fit.residuals[j][i]; !std::isnan(residual)) {
            residuals.push_back(residual);
            residualAngles.push_back(angles[i]);
        }
    }
    return data.columns[j].channel.order != Order::Position && looksLikeNoise(residuals, residualAngles);
}

/// Adds a variant of the candidate without its failing columns if these are derivatives. If positions fail as well, and
/// all columns deviate as differences do, adds the variant with the lowest order of each coordinate only, because
/// differences may have biased the fit.
void addWithFewerColumns(const Observations &data, const Candidate &candidate, Residual least,
                         std::vector<Candidate> &all)
{
    const std::vector<std::size_t> failing = failingColumns(candidate, least);
    Hypothesis hypothesis = restarted(candidate.fit.hypothesis);
    bool onlyDerivatives = !failing.empty();
    bool areDifferences = true;
    const std::vector<double> angles = crankAngles(data, candidate.fit.hypothesis);
    for (const std::size_t j : failing) {
        onlyDerivatives = onlyDerivatives && isPlottedDerivative(data.columns[j].channel);
        areDifferences = areDifferences && mayBeDifference(data, candidate, angles, j);
        hypothesis.columns[j] = {data.columns[j].channel};
        hypothesis.columns[j].isUsed = false;
    }
    const auto leftOut = static_cast<std::size_t>(std::ranges::count(hypothesis.columns, false, &ColumnUse::isUsed));
    if (onlyDerivatives && (areDifferences || 2 * leftOut <= data.columns.size()) && leftOut < data.columns.size()) {
        addWithVariants(data, std::move(hypothesis), all);
    } else if (areDifferences && isAsWritten(data, candidate)) {
        hypothesis = restarted(candidate.fit.hypothesis);
        for (ColumnUse &use : hypothesis.columns) {
            use.isUsed =
                !isPlottedDerivative(use.channel) || std::ranges::none_of(hypothesis.columns, [&](const ColumnUse &o) {
                    return o.channel.coordinate == use.channel.coordinate && o.channel.order < use.channel.order;
                });
        }
        Candidate lowest = fitCandidate(data, std::move(hypothesis));
        if (lowest.fit.exists() && lowest.acceptance != Acceptance::Rejected) {
            all.push_back(std::move(lowest));
        }
    }
}

/// Fits a hypothesis and adds it with its variants, unless it is known.
void addWithVariants(const Observations &data, Hypothesis hypothesis, std::vector<Candidate> &all)
{
    constexpr double kNear = 0.3; // largest Candidate::distance for which equal weights are tried
    if (isKnown(hypothesis, all)) {
        return;
    }
    const Candidate candidate = fitCandidate(data, std::move(hypothesis));
    if (!candidate.fit.exists() || isKnown(candidate.fit.hypothesis, all)) {
        return;
    }
    all.push_back(candidate);
    addWithoutIdleOffsets(data, candidate, all);
    if (candidate.acceptance == Acceptance::Rejected) {
        addWithFewerColumns(data, candidate, Residual::Unexplained, all);
    }
    if (std::ranges::count(candidate.residuals, Residual::Systematic) > 0) {
        addWithFewerColumns(data, candidate, Residual::Systematic, all);
    }
    if (candidate.acceptance == Acceptance::Rejected && !candidate.fit.hypothesis.isBalanced &&
        candidate.distance < kNear) {
        Hypothesis balanced = restarted(candidate.fit.hypothesis);
        balanced.isBalanced = true;
        addWithVariants(data, std::move(balanced), all);
    }
}

/// Shapes for files in which two columns have each other's headings: those exchanges with which a motion fits best.
std::vector<Fit> exchangedShapes(const Observations &data, SpeedCandidates speeds, double scoreBefore,
                                 const std::stop_token &stop)
{
    constexpr std::size_t kMostFitted = 6;
    constexpr std::size_t kMost = 4;
    constexpr double kLeastGain = 24.0; // the price of an exchange
    constexpr std::size_t kRows = 40;
    std::vector<ColumnUse> columns = plainColumns(data);
    if (speeds.periodic.size() > 1) {
        speeds.periodic.erase(speeds.periodic.begin() + 1, speeds.periodic.end());
    }
    speeds.shortArc.clear();
    const auto mayBeExchanged = [&](std::size_t j) {
        return tellsShape(data.columns[j]) &&
               (columns[j].channel.coordinate == R4x || columns[j].channel.coordinate == Theta3);
    };
    std::vector<std::pair<double, std::vector<ColumnUse>>>
        exchanges; // with the misfit of the nearest shape of the grid
    for (std::size_t i = 0; i < columns.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (mayBeExchanged(i) && mayBeExchanged(j)) {
                std::swap(columns[i].channel, columns[j].channel);
                exchanges.emplace_back(leastDissimilarity(data, columns, speeds, kRows), columns);
                std::swap(columns[i].channel, columns[j].channel);
            }
        }
    }
    std::ranges::sort(exchanges, {}, &std::pair<double, std::vector<ColumnUse>>::first);
    exchanges.resize(std::min(exchanges.size(), kMostFitted));
    std::vector<Fit> shapes;
    for (const auto &[dissimilarity, exchanged] : exchanges) {
        std::vector<Fit> fits = searchShapes(data, exchanged, speeds, {kRows, 2 * kRows, stop});
        if (!fits.empty() && fits.front().score < scoreBefore - kLeastGain) {
            shapes.push_back(std::move(fits.front()));
        }
    }
    std::ranges::sort(shapes, {}, &Fit::score);
    shapes.resize(std::min(shapes.size(), kMost));
    return shapes;
}

/// Whether the residual of a column exceeds a hundredth of its spread.
bool isFarOff(const Observations &data, const Fit &shape)
{
    constexpr double kPart = 0.01;
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        const double largest = kPart * data.columns[j].spread;
        if (shape.noiseVariances[j] > largest * largest) {
            return true;
        }
    }
    return false;
}

/// The bonus of a hypothesis whose mechanism is near the given one. If the same fault can be described in two ways,
/// this prefers the description that belongs to the given mechanism.
double bonusOf(const Observations &data, const Hypothesis &hypothesis, const Parameters &given)
{
    constexpr double kBonus = 24.0;
    constexpr double kPart = 0.25;
    const Parameters found = parametersOf(data, hypothesis);
    const bool isAbout = !data.isByCrankAngle && found.branch == given.branch &&
                         std::abs(found.a - given.a) <= kPart * given.a &&
                         std::abs(found.b - given.b) <= kPart * given.b &&
                         std::abs(found.c - given.c) <= kPart * std::max(std::abs(given.c), given.a) &&
                         std::abs(found.omega2 - given.omega2) <= kPart * std::abs(given.omega2) &&
                         std::abs(std::remainder(found.theta20 - given.theta20, 2.0 * std::numbers::pi)) <= kPart;
    return isAbout ? kBonus : 0.0;
}

/// Adds the images of the best candidate, each with the signs and half turns that make it the same motion.
void addImages(const Observations &data, InterpretationOptions options, std::vector<Candidate> &all)
{
    if (all.empty() || data.isByCrankAngle) {
        return;
    }
    const Candidate best = all.front();
    options.allowed = Interpretations::All;
    std::vector<Interpretation> images;
    addInterpretations(data, best.fit, options, images);
    for (Interpretation &image : images) {
        if (isImage(image.hypothesis, best.fit.hypothesis) && !isKnown(image.hypothesis, all)) {
            image.hypothesis.abscissaStep = best.fit.hypothesis.abscissaStep;
            image.hypothesis.isBalanced = best.fit.hypothesis.isBalanced;
            if (Fit fit = evaluateHypothesis(data, std::move(image.hypothesis)); fit.exists()) {
                fit.iterations = best.fit.iterations;
                all.push_back(judgedCandidate(data, std::move(fit)));
            }
        }
    }
}

/// Fits the interpretations with the least misfit.
void tryInterpretations(const Observations &data, const std::vector<Fit> &shapes, const InterpretationOptions &options,
                        std::vector<Candidate> &all)
{
    const std::size_t most = options.allowed == Interpretations::All ? 5 : 3;
    std::vector<Interpretation> interpretations;
    for (const Fit &shape : shapes) {
        addInterpretations(data, shape, options, interpretations);
    }
    for (Interpretation &interpretation : interpretations) {
        interpretation.misfit -= bonusOf(data, interpretation.hypothesis, options.given);
    }
    std::ranges::stable_sort(interpretations, {}, &Interpretation::misfit);
    std::size_t tried = 0;
    for (std::size_t i = 0; i < interpretations.size() && tried < most && !options.stop.stop_requested(); ++i) {
        const Hypothesis &hypothesis = interpretations[i].hypothesis;
        const bool isPlain = std::ranges::all_of(hypothesis.columns, &ColumnUse::isPlain) &&
                             !(data.isByCrankAngle && hypothesis.isFree[indexOf(Parameter::Theta20)]);
        const auto before = std::span(interpretations).first(i);
        if ((options.allowed == Interpretations::Offsets && isPlain) ||
            std::ranges::any_of(before,
                                [&](const Interpretation &other) { return isSame(other.hypothesis, hypothesis); })) {
            continue;
        }
        ++tried;
        addWithVariants(data, hypothesis, all);
    }
}

} // namespace

bool isAsWritten(const Observations &data, const Candidate &candidate)
{
    const Hypothesis &hypothesis = candidate.fit.hypothesis;
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        if (!hypothesis.columns[j].isPlain() || hypothesis.columns[j].channel != data.columns[j].channel) {
            return false;
        }
    }
    return !data.isByCrankAngle ||
           (hypothesis.abscissaFactor == 1.0 && !hypothesis.isFree[indexOf(Parameter::Theta20)]);
}

Candidate fitCandidate(const Observations &data, Hypothesis hypothesis)
{
    constexpr int kRounds = 12;
    Fit fit = fitHypothesis(data, std::move(hypothesis), kRounds);
    if (!fit.exists()) {
        return {};
    }
    const bool isRounded = fit.hypothesis.abscissaStep > 0.0;
    Hypothesis exact = fit.hypothesis;
    Candidate candidate = judgedCandidate(data, std::move(fit));
    if (isRounded) {
        exact.abscissaStep = 0.0;
        fit = fitHypothesis(data, std::move(exact), kRounds);
        if (Candidate other = fit.exists() ? judgedCandidate(data, std::move(fit)) : Candidate();
            other.fit.exists() && isBetter(other, candidate)) {
            return other;
        }
    }
    return candidate;
}

std::vector<Candidate> searchCandidates(const Observations &data, const Parameters &given, const std::stop_token &stop)
{
    constexpr std::size_t kMostShapes = 6;
    std::vector<Candidate> all;
    const SpeedCandidates speeds = speedCandidates(data);
    std::vector<Fit> shapes = searchShapes(data, plainColumns(data), speeds, {40, 80, stop});
    shapes.resize(std::min(shapes.size(), kMostShapes));
    InterpretationOptions options{Interpretations::Plain, given, !speeds.shortArc.empty(), stop};
    for (const Interpretations allowed : {Interpretations::Plain, Interpretations::Offsets, Interpretations::All}) {
        options.allowed = allowed;
        if (allowed == Interpretations::All && !shapes.empty() && isFarOff(data, shapes.front())) {
            std::vector<Fit> exchanged = exchangedShapes(data, speeds, shapes.front().score, stop);
            shapes.insert(shapes.begin(), exchanged.begin(), exchanged.end());
        }
        tryInterpretations(data, shapes, options, all);
        std::ranges::stable_sort(all, isBetter);
        if (stop.stop_requested() ||
            (!all.empty() && all.front().acceptance == Acceptance::Identified && isAsWritten(data, all.front()))) {
            break;
        }
    }
    addImages(data, options, all);
    for (Candidate &candidate : all) {
        candidate.price -= bonusOf(data, candidate.fit.hypothesis, given);
    }
    std::ranges::stable_sort(all, isBetter);
    return all;
}

} // namespace slidercrank
