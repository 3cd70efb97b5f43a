// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/decision.h"

#include "core/identification/candidate_search.h"
#include "core/identification/least_squares.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slidercrank
{

namespace
{

using Outcome = Identification::Outcome;
using Lack = Identification::Lack;
using Why = Identification::Alternative::Why;

constexpr double kMargin = 12.0;          // of the score, odds of 1 : 400: explanations within it are equally good
constexpr double kFarErrors = 5.0;        // standard errors between different mechanisms
constexpr double kLeastDifference = 1e-3; // of a parameter's size

/// Whether a mechanism and all its images differ from another one by more than the standard errors explain.
bool isAnother(const Parameters &one, const std::array<double, kParameterCount> &errors, const Parameters &other)
{
    const auto tolerance = [&](Parameter parameter, double size) {
        const double error = errors[indexOf(parameter)];
        return std::max(kLeastDifference * size, std::isfinite(error) ? kFarErrors * error : 0.0);
    };
    return std::ranges::none_of(mirrorImages(other), [&](const Parameters &image) {
        return std::abs(one.a - image.a) <= tolerance(Parameter::A, one.a) &&
               std::abs(one.b - image.b) <= tolerance(Parameter::B, one.b) &&
               std::abs(one.c - image.c) <= tolerance(Parameter::C, std::max(std::abs(one.c), one.a)) &&
               std::abs(one.omega2 - image.omega2) <= tolerance(Parameter::Omega2, std::abs(one.omega2)) &&
               std::abs(std::remainder(one.theta20 - image.theta20, kTurn)) <= tolerance(Parameter::Theta20, 2.0);
    });
}

struct Image {
    Candidate candidate;
    Why why;
};

/// The other images of a candidate that the columns do not exclude.
std::vector<Image> remainingImages(const Observations &data, const Candidate &candidate)
{
    std::vector<Image> remaining;
    if (data.isByCrankAngle) { // the origin of the angle distinguishes them
        return remaining;
    }
    const std::array<Parameters, 8> images = mirrorImages(middleParameters(candidate.fit.hypothesis));
    for (std::size_t i = 1; i < images.size(); ++i) {
        Hypothesis hypothesis = candidate.fit.hypothesis;
        setMiddleParameters(images[i], hypothesis);
        Fit fit = evaluateHypothesis(data, std::move(hypothesis));
        if (fit.exists() && std::abs(fit.chiSquare - candidate.fit.chiSquare) <= kMargin &&
            fit.score < candidate.fit.score + kMargin) {
            fit.iterations = candidate.fit.iterations;
            remaining.push_back({judgedCandidate(data, std::move(fit)), i > 3    ? Why::OtherAssembly
                                                                        : i == 1 ? Why::Reversed
                                                                                 : Why::MirrorImage});
        }
    }
    return remaining;
}

/// Swaps the candidate with that image whose assembly and sense of rotation are those of the given mechanism, if any.
void chooseImageLike(const Parameters &given, Candidate &candidate, std::vector<Image> &images)
{
    const auto likeness = [&](const Candidate &one) {
        const Parameters p = middleParameters(one.fit.hypothesis);
        return 2 * static_cast<int>(p.branch == given.branch) + static_cast<int>(p.omega2 * given.omega2 > 0.0);
    };
    for (Image &image : images) {
        if (likeness(image.candidate) > likeness(candidate)) {
            std::swap(image.candidate, candidate);
        }
    }
}

/// The sum of ln(z / sqrt(2 π e V)) over the used values, with the spread z of the column, and their number.
std::pair<double, double> evidenceAndCount(const Observations &data, const Fit &fit)
{
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        const double spread = data.columns[j].spread * std::abs(fit.hypothesis.columns[j].factor());
        for (std::size_t i = 0; i < data.abscissa.size(); ++i) {
            if (!std::isnan(fit.residuals[j][i])) {
                count += 1.0;
                sum += std::log(spread / std::sqrt(kTurn * std::numbers::e * fit.variances[j][i]));
            }
        }
    }
    return {sum, count};
}

/// Whether chi-square grows by 9, within a factor of 2, when each unknown is moved by three standard errors and the
/// others follow it.
bool isParabolic(const Observations &data, const Fit &fit, const Eigen::MatrixXd &covariance)
{
    constexpr double kErrors = 3.0;
    constexpr double kArithmetic = 1e-12;
    const double least = chiSquareAt(data, fit, fit.hypothesis.unknowns);
    for (Eigen::Index k = 0; k < covariance.cols(); ++k) {
        Eigen::VectorXd step = kErrors / std::sqrt(covariance(k, k)) * covariance.col(k);
        for (std::size_t i = 0; i < kParameterCount; ++i) {
            step[static_cast<Eigen::Index>(i)] *= fit.hypothesis.isFree[i] ? 1.0 : 0.0;
        }
        const Eigen::VectorXd arithmetic = kArithmetic * fit.hypothesis.unknowns.cwiseAbs();
        if ((step.cwiseAbs().array() <= arithmetic.array()).all()) { // held, or less than double precision resolves
            continue;
        }
        for (const double sign : {-1.0, 1.0}) {
            const double growth = chiSquareAt(data, fit, fit.hypothesis.unknowns + sign * step) - least;
            if (!(growth > 0.5 * kErrors * kErrors && growth < 2.0 * kErrors * kErrors)) {
                return false;
            }
        }
    }
    return true;
}

/// The difference to the speed of an alias: positions alone, in few evenly spaced rows per turn, do not determine the
/// speed. 0 if there is no alias.
double aliasDistance(const Observations &data, double speed)
{
    constexpr double kFewestRowsPerTurn = 4.5; // 1.3 rows a turn look like 4.3
    const bool positionsOnly = std::ranges::none_of(data.columns, [](const ObservedColumn &column) {
        return column.channel.coordinate == Theta2 ||
               (column.channel.order != Order::Position && column.channel.coordinate != R4y);
    });
    if (data.isByCrankAngle || !positionsOnly) {
        return 0.0;
    }
    constexpr double kOffGrid = 0.02;
    const double interval = data.interval();
    for (const double at : data.abscissa) {
        const double steps = (at - data.abscissa.front()) / interval;
        if (std::abs(steps - std::round(steps)) > kOffGrid + data.printedStep / interval) {
            return 0.0;
        }
    }
    const double difference = kTurn / interval;
    return std::abs(speed) * kFewestRowsPerTurn > difference ? difference : 0.0;
}

/// Whether `rival` has the same interpretation as `best`, but more or other free origins.
bool isExtension(const Hypothesis &rival, const Hypothesis &best)
{
    bool hasMore = false;
    for (std::size_t j = 0; j < best.columns.size(); ++j) {
        ColumnUse use = rival.columns[j];
        hasMore = hasMore || use.hasOffset != best.columns[j].hasOffset;
        use.hasOffset = best.columns[j].hasOffset;
        if (use != best.columns[j]) {
            return false;
        }
    }
    return hasMore;
}

/// Whether two hypotheses convert the values of some column in different ways.
bool isReadDifferently(const Hypothesis &x, const Hypothesis &y)
{
    return !std::ranges::equal(x.columns, y.columns, [](const ColumnUse &one, const ColumnUse &other) {
        return one.channel == other.channel && one.factor() == other.factor() && one.isUsed == other.isUsed &&
               one.isHalfTurned() == other.isHalfTurned();
    });
}

void addAlternatives(const Observations &data, std::span<const Candidate> candidates, const Candidate &best,
                     const Uncertainty &uncertainty, Identification &result)
{
    const bool convertsValues = !isAsWritten(data, best); // headings that explain the file are believed
    const Parameters middle = middleParameters(best.fit.hypothesis);
    for (const Candidate &rival : candidates) {
        const bool isAsGood = isExtension(rival.fit.hypothesis, best.fit.hypothesis)
                                  ? rival.fit.score < best.fit.score - kMargin
                                  : rival.score() < best.score() + kMargin;
        if (rival.acceptance == best.acceptance && isAsGood &&
            ((convertsValues && isReadDifferently(rival.fit.hypothesis, best.fit.hypothesis)) ||
             isAnother(middle, uncertainty.standardError, middleParameters(rival.fit.hypothesis)))) {
            const Parameters other = parametersOf(data, rival.fit.hypothesis);
            result.outcome = Outcome::Ambiguous;
            if (std::ranges::none_of(result.alternatives,
                                     [&](const auto &known) { return areNear(known.parameters, other); })) {
                result.alternatives.push_back({Why::AnotherMechanism, other});
            }
        }
    }
    if (const double difference = aliasDistance(data, middle.omega2); difference > 0.0) {
        result.outcome = Outcome::Ambiguous;
        Hypothesis alias = best.fit.hypothesis;
        const double shift = alias.unknowns[3] > 0.0 ? -difference : difference;
        alias.unknowns[3] += shift;
        alias.unknowns[4] -= shift * data.abscissa.front();
        result.alternatives.push_back({Why::Alias, parametersOf(data, alias)});
    }
}

/// The parameters that the file does not determine: their standard error exceeds a fifth of their size.
std::array<bool, kParameterCount> openParameters(const Parameters &p, const std::array<double, kParameterCount> &errors)
{
    constexpr double kLargestPart = 0.2;
    const std::array<double, kParameterCount> sizes{p.a, p.b, std::max(std::abs(p.c), p.a), std::abs(p.omega2), 1.0};
    std::array<bool, kParameterCount> open{};
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        open[i] = errors[i] > kLargestPart * sizes[i]; // false for held parameters, whose error is NaN
    }
    return open;
}

void fillErrors(const Observations &data, const Candidate &best, const Uncertainty &uncertainty, Identification &result)
{
    const Hypothesis &hypothesis = best.fit.hypothesis;
    result.standardError = uncertainty.standardError;
    result.standardError[indexOf(Parameter::Theta20)] = data.isByCrankAngle ? kNone : uncertainty.angleAtZero;
    result.identifiable = hypothesis.isFree;
    result.identifiable[indexOf(Parameter::Theta20)] = !data.isByCrankAngle;
    result.onlyRatios = !hypothesis.isFree[indexOf(Parameter::A)];
    if (result.onlyRatios) {
        result.identifiable[indexOf(Parameter::B)] = result.identifiable[indexOf(Parameter::C)] = false;
    }
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        if (best.residuals[j] == Residual::White) {
            const ColumnUse &use = hypothesis.columns[j];
            result.noise.push_back({use.channel, toFileUnit(use.channel, std::sqrt(best.fit.noiseVariances[j]))});
        }
    }
    if (best.acceptance == Acceptance::Approximate) {
        result.noise.clear();
    }
}

} // namespace

std::optional<Lack> findLack(const Observations &data)
{
    constexpr double kFewestValues = 6.0;
    constexpr std::ptrdiff_t kFewestRows = 4;
    double values = 0.0;
    bool moves = false;
    std::vector<bool> hasValue(data.abscissa.size());
    for (const ObservedColumn &column : data.columns) {
        if (column.channel.coordinate != Theta2 && column.channel.coordinate != R4y) {
            values += column.count;
            moves = moves || column.spread > column.step;
            for (std::size_t i = 0; i < hasValue.size(); ++i) {
                hasValue[i] = hasValue[i] || !std::isnan(column.values[i]);
            }
        }
    }
    if (data.isEmpty()) {
        return Lack::FewTimeStamps;
    }
    if (values < kFewestValues) {
        return Lack::FewValues;
    }
    return std::ranges::count(hasValue, true) < kFewestRows ? std::optional(Lack::FewTimeStamps)
           : moves                                          ? std::nullopt
                                                            : std::optional(Lack::NothingMoves);
}

Uncertainty computeUncertainty(const Observations &data, const Candidate &candidate)
{
    // A systematic residual counts as ten independent errors, whatever the number of rows. An estimated noise is itself
    // uncertain.
    constexpr double kIndependentRows = 10.0;
    Uncertainty result;
    const Fit &fit = candidate.fit;
    const Hypothesis &hypothesis = fit.hypothesis;
    const Eigen::MatrixXd matrix = normalEquations(data, fit, hypothesis.unknowns).matrix;
    const Eigen::MatrixXd covariance = solveSymmetric(matrix, Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
    result.conditionNumber = conditionNumber(matrix, covariance);
    const auto [logarithms, count] = evidenceAndCount(data, fit);
    const auto unknowns = static_cast<double>(hypothesis.freeParameterCount());
    const double spare = std::max(count - unknowns, 0.0);
    result.evidence = spare < unknowns ? 0.0 : spare / count * logarithms;
    double inflation = candidate.isExact ? 1.0 : 1.0 + 2.0 / std::max(spare, 1.0);
    if (candidate.acceptance != Acceptance::Identified) {
        inflation *= std::sqrt(std::max(static_cast<double>(data.abscissa.size()) / kIndependentRows, 1.0));
    }
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        result.standardError[i] = hypothesis.isFree[i] ? inflation * std::sqrt(covariance(k, k)) : kNone;
    }
    const double variance =
        covariance(4, 4) + data.origin * data.origin * covariance(3, 3) - 2.0 * data.origin * covariance(3, 4);
    result.angleAtZero = inflation * std::sqrt(std::max(variance, 0.0));
    const UnknownLayout layout(hypothesis.columns);
    for (const Eigen::Index k : layout.offset) {
        result.offsetErrors.push_back(k >= 0 ? inflation * std::sqrt(covariance(k, k)) : kNone);
    }
    result.isParabolic = isParabolic(data, fit, covariance);
    return result;
}

Decision decideNearest(const Observations &data, std::span<const Candidate> candidates, const Parameters &given)
{
    constexpr double kFarthest =
        0.45; // largest Candidate::distance: more than half of the variance has to be explained
    Decision decision;
    Identification &result = decision.identification;
    result.parameters = given;
    result.claimNothing();
    const auto beatsConstants = [&](const Candidate &candidate) {
        for (std::size_t j = 0; j < data.columns.size(); ++j) {
            const ObservedColumn &column = data.columns[j];
            if (column.varies && candidate.fit.noiseVariances[j] > column.spread * column.spread) {
                return false;
            }
        }
        return true;
    };
    const Candidate *nearest = nullptr;
    for (const Candidate &candidate : candidates) {
        if (isAsWritten(data, candidate) && beatsConstants(candidate) &&
            (!nearest || candidate.distance < nearest->distance)) {
            nearest = &candidate;
        }
    }
    if (nearest && nearest->distance < kFarthest) {
        decision.candidate = *nearest;
        std::vector<Image> images = remainingImages(data, *nearest);
        chooseImageLike(given, *decision.candidate, images);
        result.outcome = Outcome::Nearest;
        result.iterations = nearest->fit.iterations;
        result.parameters = parametersOf(data, decision.candidate->fit.hypothesis);
        result.parameters.theta20 = data.isByCrankAngle ? given.theta20 : result.parameters.theta20;
    }
    return decision;
}

Decision decide(const Observations &data, std::span<const Candidate> candidates, const Parameters &given)
{
    constexpr double kLeastEvidence = 30.0; // nats
    Decision decision;
    Identification &result = decision.identification;
    result.parameters = given;
    result.claimNothing();
    if (candidates.empty() || candidates.front().acceptance == Acceptance::Rejected) {
        return decideNearest(data, candidates, given);
    }
    decision.candidate = candidates.front();
    Candidate &best = *decision.candidate;
    std::vector<Image> images = remainingImages(data, best);
    chooseImageLike(given, best, images);
    decision.uncertainty = computeUncertainty(data, best);
    result.iterations = best.fit.iterations;
    result.conditionNumber = decision.uncertainty.conditionNumber;
    result.openParameters = openParameters(middleParameters(best.fit.hypothesis), decision.uncertainty.standardError);
    const bool isOpen = std::ranges::count(result.openParameters, true) > 0;
    if (decision.uncertainty.evidence < kLeastEvidence || isOpen || !decision.uncertainty.isParabolic) {
        result.outcome = Outcome::Insufficient;
        result.lack = decision.uncertainty.evidence < kLeastEvidence ? Lack::NoEvidence
                      : isOpen                                       ? Lack::OpenParameters
                                                                     : Lack::NotParabolic;
        return decision;
    }
    result.parameters = parametersOf(data, best.fit.hypothesis);
    result.parameters.theta20 = data.isByCrankAngle ? given.theta20 : result.parameters.theta20;
    result.outcome = best.acceptance == Acceptance::Identified ? Outcome::Identified : Outcome::Approximate;
    fillErrors(data, best, decision.uncertainty, result);
    for (const Image &image : images) { // also for an approximate mechanism: no column excludes them
        result.alternatives.push_back({image.why, parametersOf(data, image.candidate.fit.hypothesis)});
    }
    if (result.outcome == Outcome::Identified) {
        addAlternatives(data, candidates.subspan(1), best, decision.uncertainty, result);
    }
    const double timeUnit = best.fit.hypothesis.timeUnit;
    result.parameters.omega2 /= timeUnit;
    result.standardError[indexOf(Parameter::Omega2)] /= timeUnit;
    for (Identification::Alternative &alternative : result.alternatives) {
        alternative.parameters.omega2 /= timeUnit;
    }
    return decision;
}

} // namespace slidercrank
