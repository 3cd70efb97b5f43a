// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/decision.h"

#include "core/identification/candidate_search.h"
#include "core/identification/least_squares.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

using Outcome = Identification::Outcome;
using Lack = Identification::Lack;
using Why = Identification::Alternative::Why;

constexpr double kMargin = 12.0; // of the score, odds of 1 : 400: explanations within it are equally good

/// The candidate and those of its images that the columns do not exclude, beginning with the one whose assembly and
/// sense of rotation are most like those of the given mechanism.
std::vector<Candidate> equalImages(const Observations &data, const Candidate &candidate, const Parameters &given)
{
    std::vector<Candidate> equal{candidate};
    const std::array images = mirrorImages(middleParameters(candidate.hypothesis));
    // In a file by crank angle, the origin of the angle distinguishes them.
    for (std::size_t i = 1; i < images.size() && !data.isByCrankAngle; ++i) {
        Hypothesis hypothesis = candidate.hypothesis;
        setMiddleParameters(images[i], hypothesis);
        hypothesis.isFree = {}; // only the offsets are fitted
        Fit fit = fitHypothesis(data, std::move(hypothesis), 3);
        if (fit.exists()) {
            fit.hypothesis.isFree = candidate.hypothesis.isFree;
            fit = evaluateHypothesis(data, std::move(fit.hypothesis));
        }
        if (std::abs(fit.chiSquare - candidate.chiSquare) <= kMargin && fit.score < candidate.score + kMargin) {
            equal.push_back(judgedCandidate(data, std::move(fit)));
        }
    }
    std::ranges::stable_sort(equal, {}, [&](const Candidate &image) {
        const Parameters p = middleParameters(image.hypothesis);
        return std::pair(p.branch != given.branch, p.omega2 * given.omega2 <= 0.0);
    });
    return equal;
}

/// Whether chi-square grows by 9, within a factor of 2, when each unknown is moved by three standard errors and the
/// others follow it.
bool isParabolic(const Observations &data, const Fit &fit, const Eigen::MatrixXd &covariance)
{
    constexpr double kErrors = 3.0;
    constexpr double kArithmetic = 1e-12;
    const double least = chiSquareOf(data, fit, fit.hypothesis);
    Eigen::VectorXd arithmetic = kArithmetic * fit.hypothesis.unknowns.cwiseAbs();
    arithmetic[4] += kArithmetic * std::abs(fit.hypothesis.phaseRate(data)) * (data.span() + std::abs(data.origin));
    for (Eigen::Index k = 0; k < covariance.cols(); ++k) {
        const Eigen::VectorXd step = kErrors / std::sqrt(covariance(k, k)) * covariance.col(k);
        const bool isResolved = (step.cwiseAbs().array() > arithmetic.array()).any(); // by double precision
        if (!isResolved || !fit.hypothesis.isFreeUnknown(k)) {
            continue;
        }
        for (const double sign : {-1.0, 1.0}) {
            Hypothesis moved = fit.hypothesis;
            moved.unknowns += sign * step;
            const double growth = chiSquareOf(data, fit, moved) - least;
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
        const bool isCounted = column.channel.coordinate == Theta2 && !column.hadJumps; // turns of the crank
        return isCounted || (column.channel.order != Order::Position && column.channel.coordinate != R4y);
    });
    if (data.isByCrankAngle || !positionsOnly) {
        return 0.0;
    }
    const double difference = kTurn / data.interval();
    return std::abs(speed) * kFewestRowsPerTurn > difference ? difference : 0.0;
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
    const bool convertsValues = !isAsWritten(data, best.hypothesis); // headings that explain the file are believed
    const Parameters middle = middleParameters(best.hypothesis);
    for (const Candidate &rival : candidates) {
        const bool isAnother =
            std::ranges::none_of(mirrorImages(middleParameters(rival.hypothesis)), [&](const Parameters &image) {
                return areNear(middle, image, 1e-3, uncertainty.parameterErrors);
            });
        if (rival.acceptance == best.acceptance && rival.pricedScore() < best.pricedScore() + kMargin &&
            (isAnother || (convertsValues && isReadDifferently(rival.hypothesis, best.hypothesis)))) {
            const Parameters other = parametersOf(data, rival.hypothesis);
            result.outcome = Outcome::Ambiguous;
            if (std::ranges::none_of(result.alternatives,
                                     [&](const auto &known) { return areNear(known.parameters, other); })) {
                result.alternatives.push_back({Why::AnotherMechanism, other});
            }
        }
    }
    if (const double difference = aliasDistance(data, middle.omega2); difference > 0.0) {
        result.outcome = Outcome::Ambiguous;
        Hypothesis alias = best.hypothesis;
        const double shift = middle.omega2 > 0.0 ? -difference : difference;
        alias.unknowns[3] += shift;
        alias.unknowns[4] -= shift * data.abscissa.front();
        result.alternatives.push_back({Why::Alias, parametersOf(data, alias)});
    }
}

/// The best candidate. If it frees an origin, this may only absorb the systematic errors of a filter or sensor: then
/// the best one that explains its columns up to a systematic deviation without such freedom, unless rounding explains
/// all residuals of the first one and this one deviates by more.
const Candidate &believedCandidate(std::span<const Candidate> candidates)
{
    constexpr double kSmallPart = 1e-6; // of the variance
    const Candidate &best = candidates.front();
    const auto simpler = std::ranges::find_if(candidates, [&](const Candidate &other) {
        return other.worst == Residual::Systematic && !other.hasFreeOrigin &&
               (!best.isExact || std::ranges::max(other.noiseParts) <= kSmallPart);
    });
    return best.hasFreeOrigin && simpler != candidates.end() ? *simpler : best;
}

Uncertainty computeUncertainty(const Observations &data, const Candidate &candidate)
{
    // A systematic residual counts as ten independent errors, whatever the number of rows. An estimated noise is itself
    // uncertain.
    constexpr double kIndependentRows = 10.0;
    Uncertainty result;
    const Eigen::MatrixXd matrix = normalEquations(data, candidate).matrix;
    const Eigen::MatrixXd covariance = solveSymmetric(matrix, Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
    result.conditionNumber = conditionNumber(matrix);
    const double count = candidate.valueCount;
    const double spare = std::max(count - candidate.freeCount, 0.0);
    const double information = -0.5 * (candidate.logVariance + count * std::log(kTurn * std::numbers::e));
    result.evidence = spare < candidate.freeCount ? 0.0 : spare / count * information;
    double inflation = candidate.isExact ? 1.0 : 1.0 + 2.0 / std::max(spare, 1.0);
    if (candidate.acceptance != Acceptance::Identified) {
        inflation *= std::sqrt(std::max(static_cast<double>(data.abscissa.size()) / kIndependentRows, 1.0));
    }
    result.errors = inflation * covariance.diagonal().cwiseSqrt();
    for (Eigen::Index k = 0; k < matrix.rows(); ++k) {
        result.errors[k] = candidate.hypothesis.isFreeUnknown(k) ? result.errors[k] : kNone;
    }
    std::copy_n(result.errors.data(), kParameterCount, result.parameterErrors.begin());
    const double variance =
        covariance(4, 4) + data.origin * data.origin * covariance(3, 3) - 2.0 * data.origin * covariance(3, 4);
    result.angleAtZero = inflation * std::sqrt(std::max(variance, 0.0));
    result.isParabolic = isParabolic(data, candidate, covariance);
    return result;
}

/// The mechanism of a candidate, with a of the given one if it was held, and θ20 in a file by crank angle.
Parameters foundParameters(const Observations &data, const Candidate &candidate, const Parameters &given)
{
    Parameters found = parametersOf(data, candidate.hypothesis);
    found.a = candidate.hypothesis.isFree[0] ? found.a : given.a; // exactly
    found.theta20 = data.isByCrankAngle ? given.theta20 : found.theta20;
    return found;
}

/// Says of an accepted candidate which parameters it determines, with which errors, and which columns are noisy.
void describePrecision(const Observations &data, const Decision &decision, Identification &result)
{
    const Candidate &best = decision.candidate;
    result.standardError = decision.uncertainty.parameterErrors;
    result.standardError[indexOf(Parameter::Omega2)] /= best.hypothesis.timeUnit;
    result.standardError[indexOf(Parameter::Theta20)] = data.isByCrankAngle ? kNone : decision.uncertainty.angleAtZero;
    result.identifiable = best.hypothesis.isFree;
    result.identifiable[indexOf(Parameter::Theta20)] = !data.isByCrankAngle;
    result.onlyRatios = !best.hypothesis.isFree[indexOf(Parameter::A)];
    if (result.onlyRatios) {
        result.identifiable[indexOf(Parameter::B)] = result.identifiable[indexOf(Parameter::C)] = false;
    }
    for (std::size_t j = 0; j < data.columns.size() && best.acceptance == Acceptance::Identified; ++j) {
        if (best.judgements[j] == Residual::White) {
            const Channel channel = best.hypothesis.columns[j].channel;
            result.noise.push_back({channel, toFileUnit(channel, std::sqrt(best.noiseVariances[j]))});
        }
    }
}

} // namespace

std::optional<Lack> findLack(const Observations &data)
{
    constexpr double kFewestValues = 6.0;
    constexpr std::size_t kFewestRows = 4;
    double values = 0.0;
    bool moves = false;
    for (const ObservedColumn &column : data.columns) {
        if (column.channel.coordinate != Theta2 && column.channel.coordinate != R4y) {
            values += column.count;
            moves = moves || column.spread > column.step;
        }
    }
    if (values < kFewestValues || data.abscissa.size() < kFewestRows) {
        return Lack::FewValues;
    }
    return moves ? std::nullopt : std::optional(Lack::NothingMoves);
}

Identification decideNearest(const Observations &data, std::span<const Candidate> candidates, const Parameters &given)
{
    constexpr double kFarthest =
        0.45; // largest Candidate::distance: more than half of the variance has to be explained
    Identification result;
    result.parameters = given;
    Candidate nearest;
    for (const Candidate &candidate : candidates) { // no column may deviate more than from a constant
        if (isAsWritten(data, candidate.hypothesis) && std::ranges::max(candidate.noiseParts) <= 1.0 &&
            candidate.distance < std::min(kFarthest, nearest.distance) &&
            !findFault(parametersOf(data, candidate.hypothesis))) {
            nearest = candidate;
        }
    }
    if (nearest.exists()) {
        result.iterations = nearest.iterations;
        nearest = equalImages(data, nearest, given).front();
        result.outcome = Outcome::Nearest;
        result.parameters = foundParameters(data, nearest, given);
    }
    return result;
}

Decision decide(const Observations &data, std::span<const Candidate> candidates, const Parameters &given)
{
    constexpr double kLeastEvidence = 30.0; // nats
    // For the standard error of a parameter, relative to its size; an approximate one is stated with three digits.
    constexpr double kLargestPart = 0.2;
    constexpr double kLargestApproximatePart = 0.01;
    Decision decision;
    Identification &result = decision.identification;
    result.parameters = given;
    if (candidates.empty() || believedCandidate(candidates).acceptance == Acceptance::Rejected) {
        return decision;
    }
    const Candidate &first = believedCandidate(candidates);
    const std::vector<Candidate> images = equalImages(data, first, given);
    const Candidate &best = decision.candidate = images.front();
    const Uncertainty &uncertainty = decision.uncertainty = computeUncertainty(data, best);
    result.iterations = first.iterations;
    result.conditionNumber = uncertainty.conditionNumber;
    const std::array sizes = comparisonSizes(middleParameters(best.hypothesis));
    const double most = best.acceptance == Acceptance::Identified ? kLargestPart : kLargestApproximatePart;
    for (std::size_t i = 0; i < kParameterCount; ++i) { // NaN, the error of a held parameter, is not greater
        result.openParameters[i] = uncertainty.parameterErrors[i] > most * sizes[i];
    }
    result.lack = uncertainty.evidence < kLeastEvidence                 ? Lack::FewValues
                  : std::ranges::count(result.openParameters, true) > 0 ? Lack::OpenParameters
                  : uncertainty.isParabolic                             ? Lack::Nothing
                                                                        : Lack::NotParabolic;
    if (result.lack != Lack::Nothing) {
        result.outcome = Outcome::Insufficient;
        return decision;
    }
    result.parameters = foundParameters(data, best, given);
    result.outcome = best.acceptance == Acceptance::Identified ? Outcome::Identified : Outcome::Approximate;
    describePrecision(data, decision, result);
    for (const Candidate &image : std::span(images).subspan(1)) { // also of an approximate mechanism
        const Parameters p = parametersOf(data, image.hypothesis);
        result.alternatives.push_back({p.branch != result.parameters.branch ? Why::OtherAssembly
                                       : p.c == result.parameters.c         ? Why::Reversed
                                                                            : Why::MirrorImage,
                                       p});
    }
    if (result.outcome == Outcome::Identified) {
        addAlternatives(data, candidates.subspan(1), best, uncertainty, result);
    }
    if (findFault(result.parameters)) {
        return {};
    }
    std::erase_if(result.alternatives, [](const auto &other) { return findFault(other.parameters).has_value(); });
    return decision;
}

} // namespace slidercrank
