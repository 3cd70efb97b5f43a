// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/candidate_search.h"

#include "core/identification/interpretation.h"
#include "core/identification/shape_search.h"
#include "core/import/crank_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

void addWithVariants(const Observations &data, Hypothesis hypothesis, std::vector<Candidate> &all);

/// Adds a variant of the candidate without the columns whose residuals are as bad as `least` or worse, if these are
/// derivatives or centres of links. If positions fail as well, adds the variant with the lowest order of each
/// coordinate only, because derivatives that are differences may have biased the fit.
void addWithFewerColumns(const Observations &data, const Candidate &candidate, Residual least,
                         std::vector<Candidate> &all)
{
    Hypothesis hypothesis = candidate.hypothesis;
    bool mayLeaveOut = true;
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        if (candidate.judgements[j] >= least) {
            // An exchanged column that is left out cannot show that it is exchanged.
            const Channel heading = data.columns[j].channel;
            mayLeaveOut &= mayBeLeftOut(heading) && hypothesis.columns[j].channel == heading;
            hypothesis.columns[j] = {.channel = heading, .isUsed = false};
        }
    }
    if (mayLeaveOut && keepsEnough(hypothesis)) {
        addWithVariants(data, std::move(hypothesis), all);
    } else if (isAsWritten(data, candidate.hypothesis)) {
        hypothesis = candidate.hypothesis;
        for (std::size_t j = 0; j < data.columns.size(); ++j) {
            const Channel channel = data.columns[j].channel;
            const auto isLower = [&](const ColumnUse &other) {
                return other.channel.coordinate == channel.coordinate && other.channel.order < channel.order;
            };
            hypothesis.columns[j].isUsed =
                isPlotted(channel) ? std::ranges::none_of(hypothesis.columns, isLower) : !mayBeLeftOut(channel);
        }
        Candidate lowest = keepsEnough(hypothesis) ? fitCandidate(data, std::move(hypothesis)) : Candidate();
        if (lowest.acceptance != Acceptance::Rejected) {
            all.push_back(std::move(lowest));
        }
    }
}

/// Fits a hypothesis and adds it with its variants, unless it is known.
void addWithVariants(const Observations &data, Hypothesis hypothesis, std::vector<Candidate> &all)
{
    if (isKnown(hypothesis, all)) {
        return;
    }
    const Candidate candidate = fitCandidate(data, std::move(hypothesis));
    if (!candidate.exists() || isKnown(candidate.hypothesis, all)) {
        return;
    }
    all.push_back(candidate);
    constexpr double kSmallOffset = 0.3; // smaller ones may not be determined by the file
    for (const double part : {kIdleOffset, kSmallOffset}) {
        Hypothesis without = candidate.hypothesis;
        for (std::size_t j = 0; j < data.columns.size(); ++j) {
            ColumnUse &use = without.columns[j];
            const double offset = candidate.hypothesis.offset(j);
            const bool isHalfTurnOfCrank = use.channel == kCrankAngle && std::abs(offset) > 1.0;
            if (use.hasOffset && isSmallOffset(data, candidate.hypothesis, j, part) && !isHalfTurnOfCrank) {
                use.hasOffset = false;
                use.turn += isLength(use.channel) ? 0.0 : std::numbers::pi * std::round(offset / std::numbers::pi);
            }
        }
        addWithVariants(data, std::move(without), all); // if none is small, it is known
    }
    if (candidate.acceptance == Acceptance::Rejected) {
        addWithFewerColumns(data, candidate, Residual::Unexplained, all);
    }
    if (std::ranges::count(candidate.judgements, Residual::Systematic) > 0) {
        addWithFewerColumns(data, candidate, Residual::Systematic, all);
    }
}

/// Shapes for files in which two columns have each other's headings: those exchanges with which a motion fits best.
std::vector<Fit> exchangedShapes(const Observations &data, SpeedCandidates speeds, double scoreBefore,
                                 const std::stop_token &stop)
{
    constexpr std::size_t kMost = 4;
    constexpr double kLeastGain = 24.0; // the price of an exchange
    speeds.periodic.resize(std::min(speeds.periodic.size(), std::size_t{1}));
    speeds.shortArc.clear();
    const auto mayBeExchanged = [&](std::size_t j) {
        return tellsShape(data.columns[j]) && isPlotted(data.columns[j].channel);
    };
    std::vector<Fit> shapes;
    for (std::size_t i = 0; i < data.columns.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (!mayBeExchanged(i) || !mayBeExchanged(j) || stop.stop_requested()) {
                continue;
            }
            std::vector<ColumnUse> exchanged = plainColumns(data);
            std::swap(exchanged[i].channel, exchanged[j].channel);
            std::vector<Fit> fits = searchShapes(data, exchanged, speeds);
            if (!fits.empty() && fits.front().score < scoreBefore - kLeastGain) {
                shapes.push_back(std::move(fits.front()));
            }
        }
    }
    std::ranges::sort(shapes, {}, &Fit::score);
    shapes.resize(std::min(shapes.size(), kMost));
    return shapes;
}

/// The bonus of a hypothesis whose mechanism is near the given one. If the same fault can be described in two ways,
/// this prefers the description that belongs to the given mechanism.
double bonusOf(const Observations &data, const Hypothesis &hypothesis, const Parameters &given)
{
    constexpr double kBonus = 24.0;
    constexpr double kPart = 0.25;
    return !data.isByCrankAngle && areNear(given, parametersOf(data, hypothesis), kPart) ? kBonus : 0.0;
}

/// Adds those images of the best candidate that agree with the headings. From a rough start, their fit may have been
/// worse.
void addPlainImages(const Observations &data, const Parameters &given, std::vector<Candidate> &all)
{
    constexpr double kNearly = 1e-3; // of a column's variance
    std::vector<Fit> images;
    addInterpretations(data, all.front(), {.isPlain = true, .given = given, .hasSize = true}, images);
    for (Fit &image : images) {
        image = evaluateHypothesis(data, std::move(image.hypothesis));
        if (image.exists() && std::ranges::max(image.noiseParts) < kNearly) {
            all.push_back(fitCandidate(data, image.hypothesis));
            all.push_back(judgedCandidate(data, std::move(image)));
        }
    }
}

/// Fits the interpretations with the least misfit.
void tryInterpretations(const Observations &data, const std::vector<Fit> &shapes, const InterpretationOptions &options,
                        const std::stop_token &stop, std::vector<Candidate> &all)
{
    const std::size_t most = options.isPlain ? 3 : 5;
    std::vector<Fit> interpretations;
    for (const Fit &shape : shapes) {
        addInterpretations(data, shape, options, interpretations);
    }
    for (Fit &interpretation : interpretations) {
        interpretation.score -= bonusOf(data, interpretation.hypothesis, options.given);
    }
    std::ranges::stable_sort(interpretations, {}, &Fit::score);
    std::vector<Fit> tried;
    for (const Fit &interpretation : interpretations) {
        if (tried.size() < most && !stop.stop_requested() && !isKnown(interpretation.hypothesis, tried)) {
            tried.push_back(interpretation);
            addWithVariants(data, interpretation.hypothesis, all);
        }
    }
}

} // namespace

bool isAsWritten(const Observations &data, const Hypothesis &hypothesis)
{
    const auto isSameAsHeading = [](const ColumnUse &use, const ObservedColumn &column) {
        return use.isPlain() && use.channel == column.channel;
    };
    return hypothesis.timeUnit == 1.0 && std::ranges::equal(hypothesis.columns, data.columns, isSameAsHeading) &&
           (!data.isByCrankAngle ||
            (hypothesis.abscissaFactor == 1.0 && !hypothesis.isFree[indexOf(Parameter::Theta20)]));
}

bool isIdentified(const std::vector<Candidate> &candidates)
{
    return !candidates.empty() && candidates.front().acceptance == Acceptance::Identified;
}

Candidate fitCandidate(const Observations &data, Hypothesis hypothesis)
{
    constexpr int kRounds = 12;
    Fit fit = fitHypothesis(data, std::move(hypothesis), kRounds);
    return fit.exists() ? judgedCandidate(data, std::move(fit)) : Candidate();
}

std::vector<Candidate> searchCandidates(const Observations &data, const Parameters &given, const std::stop_token &stop)
{
    constexpr std::size_t kMostShapes = 6;
    constexpr double kFarOff = 1e-4; // of a column's variance
    std::vector<Candidate> all;
    const SpeedCandidates speeds = speedCandidates(data);
    std::vector<Fit> shapes = searchShapes(data, plainColumns(data), speeds);
    shapes.resize(std::min(shapes.size(), kMostShapes));
    InterpretationOptions options{.given = given};
    for (const bool isPlain : {true, false}) {
        options.isPlain = isPlain;
        if (!isPlain && !shapes.empty() && std::ranges::max(shapes.front().noiseParts) > kFarOff) {
            std::vector<Fit> exchanged = exchangedShapes(data, speeds, shapes.front().score, stop);
            shapes.insert(shapes.begin(), exchanged.begin(), exchanged.end());
        }
        if (isIdentified(all)) { // its columns that are left out may be in another unit
            shapes.push_back(all.front());
        }
        tryInterpretations(data, shapes, options, stop, all);
        std::ranges::stable_sort(all, isBetter);
        if (stop.stop_requested() || (isIdentified(all) && isAsWritten(data, all.front().hypothesis))) {
            break;
        }
    }
    if (!all.empty() && all.front().acceptance != Acceptance::Rejected && !isAsWritten(data, all.front().hypothesis)) {
        addPlainImages(data, given, all);
    }
    for (Candidate &candidate : all) {
        candidate.price -= bonusOf(data, candidate.hypothesis, given);
    }
    std::ranges::stable_sort(all, isBetter);
    return all;
}

} // namespace slidercrank
