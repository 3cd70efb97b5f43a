// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/decision.h"

#include "core/identification/candidate_search.h"
#include "core/identification/interpretation.h"
#include "core/identification/least_squares.h"
#include "core/import/crank_angles.h"
#include "core/mechanism/find_element.h"
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
        Fit fit = evaluateHypothesis(data, hypothesis);
        if (candidate.hasFreeOrigin && fit.exists()) {
            hypothesis.isFree = {}; // only the offsets are fitted
            fit = fitHypothesis(data, std::move(hypothesis), 3);
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
    const double least = chiSquareOf(data, fit, fit.hypothesis);
    for (Eigen::Index k = 0; k < covariance.cols(); ++k) {
        const Eigen::VectorXd step = kErrors / std::sqrt(covariance(k, k)) * covariance.col(k);
        if (!fit.hypothesis.isFreeUnknown(k)) {
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
/// all residuals of the first one.
const Candidate &believedCandidate(std::span<const Candidate> candidates)
{
    const Candidate &best = candidates.front();
    const Candidate *const simpler = findElement(candidates, [&](const Candidate &other) {
        return other.worst == Residual::Systematic && !other.hasFreeOrigin && !best.isExact;
    });
    return best.hasFreeOrigin && simpler ? *simpler : best;
}

/// The covariance of the unknowns that follows from errors of the values that are not independent: the values may be
/// truncated instead of rounded, unless the residuals exclude that, and a column with noise may have a smooth error, a
/// sum of harmonics of the crank angle. Its size is that of the part that the fit does not absorb, in excess of noise.
/// An unknown origin of the only column may hide it: then it is at least the linearity error of a usual sensor.
Eigen::MatrixXd covarianceOfCommonErrors(const Observations &data, const Candidate &candidate,
                                         const NormalEquations &equations, const Eigen::MatrixXd &covariance)
{
    constexpr double kSigmas = 3.0;
    constexpr double kLinearity = 2e-3; // of the range
    const Eigen::Index unknowns = covariance.rows();
    const Eigen::Index count = equations.gradient.size() - unknowns;
    const Eigen::VectorXd projections = equations.gradient.tail(count);
    const Eigen::MatrixXd products = equations.matrix.topRightCorner(unknowns, count);
    Eigen::MatrixXd changes = covariance * products;
    Eigen::MatrixXd visible = equations.matrix.bottomRightCorner(count, count) - products.transpose() * changes;
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(unknowns, unknowns);
    Eigen::VectorXd sizes(count);
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        const Eigen::Index k = kErrorsOfColumn * static_cast<Eigen::Index>(j);
        const double half = 0.5 * data.columns[j].step * candidate.hypothesis.columns[j].factor();
        if (half * (half * visible(k, k) - 2.0 * projections[k]) <= kMargin) { // growth of chi-square
            result += half * half * changes.col(k) * changes.col(k).transpose();
        }
        if (candidate.hasFreeOrigin && !candidate.isExact && data.columns.size() == 1) {
            result += std::pow(kLinearity * data.columns[j].range, 2.0) * changes * changes.transpose();
        }
        sizes.segment<kErrorsOfColumn>(k).setConstant(std::sqrt(candidate.noiseVariances[j]));
    }
    // The projections of white noise have the covariance `visible`.
    changes *= sizes.asDiagonal();
    visible = sizes.asDiagonal() * visible * sizes.asDiagonal();
    const double squares = visible.squaredNorm();
    const double excess =
        projections.cwiseProduct(sizes).squaredNorm() - visible.trace() - kSigmas * std::sqrt(2.0 * squares);
    if (excess > 0.0) {
        result += excess / squares * changes * changes.transpose();
    }
    return result;
}

Uncertainty computeUncertainty(const Observations &data, const Candidate &candidate)
{
    Uncertainty result;
    std::vector<double> angles;
    for (std::size_t row = 0; row < data.abscissa.size(); ++row) {
        angles.push_back(crankAngle(data, candidate.hypothesis, row));
    }
    const NormalEquations equations =
        normalEquations<kErrorsOfColumn>(data, candidate, harmonicBasis(angles, kErrorsOfColumn / 2));
    const Eigen::Index unknowns = candidate.hypothesis.unknowns.size();
    const Eigen::MatrixXd matrix = equations.matrix.topLeftCorner(unknowns, unknowns);
    const Eigen::MatrixXd covariance = solveSymmetric(matrix, Eigen::MatrixXd::Identity(unknowns, unknowns));
    result.conditionNumber = conditionNumber(matrix);
    const double count = candidate.valueCount;
    const double spare = std::max(count - candidate.freeCount, 0.0);
    const double information = -0.5 * (candidate.logVariance + count * std::log(kTurn * std::numbers::e));
    result.evidence = spare < candidate.freeCount ? 0.0 : spare / count * information;
    // An estimated noise is itself uncertain.
    const double inflation = candidate.isExact ? 1.0 : 1.0 + 2.0 / std::max(spare, 1.0);
    const Eigen::MatrixXd total =
        inflation * inflation * covariance + covarianceOfCommonErrors(data, candidate, equations, covariance);
    result.errors = total.diagonal().cwiseSqrt();
    for (Eigen::Index k = 0; k < unknowns; ++k) {
        result.errors[k] = candidate.hypothesis.isFreeUnknown(k) ? result.errors[k] : kNone;
    }
    std::copy_n(result.errors.data(), kParameterCount, result.parameterErrors.begin());
    const double variance = total(4, 4) + data.origin * data.origin * total(3, 3) - 2.0 * data.origin * total(3, 4);
    result.angleAtZero = std::sqrt(std::max(variance, 0.0));
    result.isParabolic = isParabolic(data, candidate, covariance);
    return result;
}

/// The candidate with a = b and c = 0, if it differs from that by less than a millionth and explains the file as well.
/// Such a mechanism folds, and the smallest errors of a, b and c change its derivatives.
std::optional<Candidate> foldedMechanism(const Observations &data, const Candidate &candidate)
{
    constexpr double kNearly = 1e-6;
    Hypothesis folded = candidate.hypothesis;
    const double a = folded.unknowns[0];
    const double distance = std::hypot(folded.unknowns[1] - a, folded.unknowns[2]);
    folded.unknowns.segment(1, 2) << a, 0.0;
    return distance < kNearly * a && chiSquareOf(data, candidate, folded) < candidate.chiSquare + kMargin
               ? std::optional(judgedCandidate(data, evaluateHypothesis(data, std::move(folded))))
               : std::nullopt;
}

/// Whether a free origin is smaller than five of its standard errors or, for the crank angle, than 0.06°.
bool hasUncertainOrigin(const Observations &data, const Hypothesis &hypothesis, const Uncertainty &uncertainty)
{
    constexpr double kErrors = 5.0;
    constexpr double kSmallestOfCrank = 0.06;
    return std::ranges::any_of(conventionsOf(data, hypothesis), [&](const Convention &convention) {
        if (convention.kind != Convention::Kind::ZeroPoint) {
            return false;
        }
        const Channel channel = convention.channels.front();
        const double smallest = channel == kCrankAngle ? kSmallestOfCrank : 0.0;
        return std::abs(convention.amount) < std::max(kErrors * uncertainty.originError(hypothesis, channel), smallest);
    });
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

double Uncertainty::originError(const Hypothesis &hypothesis, Channel channel) const
{
    const bool isCrank = channel == kCrankAngle;
    const Eigen::Index k =
        isCrank ? indexOf(Parameter::Theta20) : Hypothesis::offsetIndex(columnIndex(hypothesis.columns, channel));
    return toFileUnit(channel, errors[k]);
}

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
    double smallest = 0.45; // of a column's variance: more than half of it has to be explained
    Identification result;
    result.parameters = given;
    Candidate nearest;
    for (const Candidate &candidate : candidates) {
        const double noise = std::ranges::max(candidate.noiseParts);
        if (noise < smallest && isAsWritten(data, candidate.hypothesis) &&
            !findFault(parametersOf(data, candidate.hypothesis))) {
            smallest = noise;
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
    constexpr double kLargestApproximatePart = 0.006;
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
    if (hasUncertainOrigin(data, best.hypothesis, uncertainty)) {
        std::vector<Candidate> plain(candidates.begin(), candidates.end());
        std::erase_if(plain, [&](const Candidate &other) { return !isAsWritten(data, other.hypothesis); });
        if (Decision other = decide(data, plain, given); other.identification.hasMechanism()) {
            return other;
        }
        result.lack = Lack::NotParabolic;
    }
    if (result.lack != Lack::Nothing) {
        result.outcome = Outcome::Insufficient;
        return decision;
    }
    if (std::optional<Candidate> folded = foldedMechanism(data, best)) {
        decision.candidate = *std::move(folded);
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
