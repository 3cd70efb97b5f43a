// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/decision.h"

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

/// Within so much of a score (odds of 1 : 400) two explanations are equally good.
constexpr double kMargin = 12.0;

constexpr double kFarStandardErrors = 5.0;

FitProblem problemOf(const SearchRows &rows, const Candidate &candidate)
{
    FitProblem problem = problemOf(rows.all, candidate.reading);
    problem.clockStep = candidate.isClockExact ? 0.0 : problem.clockStep;
    return problem;
}

/// Whether another mechanism, images apart, lies outside of what the standard errors leave room for.
bool isAnother(const Parameters &one, const std::array<double, kParameterCount> &errors, const Parameters &other)
{
    const auto room = [&](Parameter parameter, double size) {
        const double error = errors[indexOf(parameter)];
        return std::max(1e-3 * size, std::isfinite(error) ? kFarStandardErrors * error : 0.0);
    };
    return std::ranges::none_of(mirrorImages(other), [&](const Parameters &image) {
        return std::abs(one.a - image.a) <= room(Parameter::A, one.a) &&
               std::abs(one.b - image.b) <= room(Parameter::B, one.b) &&
               std::abs(one.c - image.c) <= room(Parameter::C, std::max(std::abs(one.c), one.a)) &&
               std::abs(one.omega2 - image.omega2) <= room(Parameter::Omega2, std::abs(one.omega2)) &&
               std::abs(std::remainder(one.theta20 - image.theta20, 2.0 * std::numbers::pi)) <=
                   room(Parameter::Theta20, 2.0);
    });
}

/// The same reading, but for a constant more or less.
bool isSameButForZeros(const FileReading &x, const FileReading &y)
{
    return std::ranges::equal(x, y, [](ColumnReading one, ColumnReading other) {
        one.isZeroFree = other.isZeroFree;
        return one == other;
    });
}

struct Image {
    Fit fit;
    Why why;
};

/// The images that the columns do not exclude, itself apart.
std::vector<Image> imagesLeft(const FitProblem &problem, const Candidate &candidate, const std::stop_token &stop)
{
    constexpr FreeParameters kNoneFree{};
    const std::array<Parameters, 8> images = mirrorImages(candidate.fit.parameters);
    std::vector<Image> left;
    for (std::size_t i = 1; i < images.size(); ++i) {
        const Fit fitted = fit(problem, images[i], kNoneFree, 3, stop);
        if (fitted.exists() && std::abs(fitted.chiSquared - candidate.fit.chiSquared) <= kMargin &&
            fitted.score < candidate.fit.score + kMargin) {
            left.push_back({fitted, i > 3 ? Why::OtherAssembly : i == 1 ? Why::Reversed : Why::MirrorImage});
        }
    }
    return left;
}

/// Of mechanisms that no column tells apart, the one that is assembled and turns as the one at hand.
void turnLike(const Parameters &given, Fit &fit, std::vector<Image> &images)
{
    const auto likeness = [&](const Parameters &p) {
        return 2 * static_cast<int>(p.branch == given.branch) + static_cast<int>(p.omega2 * given.omega2 > 0.0);
    };
    for (Image &image : images) {
        if (likeness(image.fit.parameters) > likeness(fit.parameters)) {
            std::swap(image.fit, fit);
        }
    }
}

bool hasOnlyAngles(const SearchRows &rows)
{
    return !rows.isFree[indexOf(Parameter::A)];
}

std::array<bool, kParameterCount> openParametersOf(const Fit &fit, const Uncertainty &uncertainty)
{
    constexpr double kMostOfSize = 0.2;
    const Parameters &p = fit.parameters;
    const std::array<double, kParameterCount> sizes{p.a, p.b, std::max(std::abs(p.c), p.a), std::abs(p.omega2), 1.0};
    std::array<bool, kParameterCount> open{};
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        open[i] = uncertainty.standardError[i] > kMostOfSize * sizes[i]; // not where it is held: NaN
    }
    return open;
}

/// The interval that all instants are multiples of, as far as their rounding tells; 0: none.
double gridOf(const Observations &observations)
{
    double interval = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < observations.time.size(); ++i) {
        interval = std::min(interval, observations.time[i] - observations.time[i - 1]);
    }
    // The shortest is too short by what it was rounded: the whole time tells better.
    const double whole = observations.time.back() - observations.time.front();
    interval = whole / std::round(whole / interval);
    constexpr double kOffGrid = 0.02;
    for (const double t : observations.time) {
        const double steps = (t - observations.time.front()) / interval;
        if (std::abs(steps - std::round(steps)) > kOffGrid + observations.printedClockStep / interval) {
            return 0.0;
        }
    }
    return interval;
}

/// By how much the speed may be another at the same instants: positions alone, at even instants, few a turn; 0: not.
double aliasDistanceOf(const Observations &observations, const Fit &fit)
{
    // 1.3 rows a turn look like 4.3.
    constexpr double kFewestRowsATurn = 4.5;
    const double interval = observations.hasPositionOnly() ? gridOf(observations) : 0.0;
    const double turnsARow = std::abs(fit.parameters.omega2) * interval / (2.0 * std::numbers::pi);
    return turnsARow * kFewestRowsATurn > 1.0 ? 2.0 * std::numbers::pi / interval : 0.0;
}

double rmsInSteps(const FitProblem &problem, const FitResiduals &left)
{
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        for (const double residual : left.residuals[k]) {
            if (!std::isnan(residual) && problem.columns[k].step > 0.0) {
                const double steps = residual / problem.columns[k].step;
                squares += steps * steps;
                count += 1.0;
            }
        }
    }
    return std::sqrt(squares / std::max(count, 1.0));
}

void fillStandardErrors(const SearchRows &rows, const Uncertainty &uncertainty, Identification &result)
{
    const FitUnits &units = rows.all.units;
    const std::array<double, kParameterCount> scale{units.mm, units.mm, units.mm, 1.0 / units.second, 1.0};
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        result.standardError[i] = scale[i] * uncertainty.standardError[i];
        result.identifiable[i] = std::isfinite(result.standardError[i]);
    }
    result.standardError[indexOf(Parameter::Theta20)] = uncertainty.atClockZero;
    result.onlyRatios = hasOnlyAngles(rows);
    if (result.onlyRatios) {
        for (const Parameter length : {Parameter::A, Parameter::B, Parameter::C}) {
            result.identifiable[indexOf(length)] = false;
        }
    }
}

} // namespace

std::optional<Lack> lackOf(const Observations &observations)
{
    constexpr std::size_t kFewestValues = 6;
    constexpr std::size_t kFewestInstants = 4;
    std::size_t values = 0;
    bool moves = false;
    std::vector<bool> isUsed(observations.time.size());
    for (const ObservedColumn &column : observations.columns) {
        const Coordinate coordinate = column.channel.coordinate;
        if (isPlotted(column.channel) || coordinate == R3x || coordinate == R3y) {
            values += column.count;
            moves = moves || column.spread > column.step;
            for (std::size_t row = 0; row < isUsed.size(); ++row) {
                isUsed[row] = isUsed[row] || !std::isnan(column.values[row]);
            }
        }
    }
    if (values < kFewestValues) {
        return Lack::FewValues;
    }
    if (static_cast<std::size_t>(std::ranges::count(isUsed, true)) < kFewestInstants) {
        return Lack::FewInstants;
    }
    return moves ? std::nullopt : std::optional(Lack::NothingMoves);
}

Identification decisionOn(const SearchRows &rows, std::span<const Candidate> candidates, const Parameters &given,
                          const std::stop_token &stop)
{
    Identification result;
    result.parameters = given;
    result.claimNothing();
    if (stop.stop_requested()) {
        result.stopped = true;
        return result;
    }
    if (candidates.empty() || !candidates.front().fit.exists()) {
        return result;
    }
    // Of what does not stand, the nearest: a score calls misfit noise, and gives up one column for another.
    const Candidate &best = candidates.front().standing.stands
                                ? candidates.front()
                                : *std::ranges::min_element(candidates, {}, &Candidate::distance);
    const FitUnits &units = rows.all.units;
    const FitProblem problem = problemOf(rows, best);
    result.iterations = best.fit.iterations;
    FitResiduals left;
    residualsOf(problem, best.fit, left);
    result.rms = rmsInSteps(problem, left);
    Fit chosen = best.fit;
    std::vector<Image> images = imagesLeft(problem, best, stop);
    turnLike(given, chosen, images);
    result.parameters = units.fromFit(chosen.parameters);
    if (!best.standing.stands) {
        constexpr double kFar = 0.45; // of all that the columns vary: more than half has to be explained
        result.outcome = best.distance < kFar ? Outcome::Nearest : Outcome::None;
        result.parameters = result.outcome == Outcome::None ? given : result.parameters;
        return result;
    }

    const Uncertainty uncertainty = uncertaintyOf(rows.all, problem, best.fit, best.isFree, best.standing);
    result.conditionNumber = uncertainty.conditionNumber;
    const auto insufficient = [&](Lack lack) {
        result.outcome = Outcome::Insufficient;
        result.lack = lack;
        result.parameters = given;
        result.claimNothing();
        return result;
    };
    constexpr double kLeastEvidence = 30.0; // nats
    const std::size_t unknowns = freeCount(problem, best.isFree);
    if (problem.valueCount < 2 * unknowns || uncertainty.evidence < kLeastEvidence) {
        return insufficient(Lack::NoEvidence);
    }
    result.openParameters = openParametersOf(best.fit, uncertainty);
    if (std::ranges::count(result.openParameters, true) > 0) {
        return insufficient(Lack::OpenParameters);
    }
    if (!uncertainty.isStraight) {
        return insufficient(Lack::Crooked);
    }

    fillStandardErrors(rows, uncertainty, result);
    for (const Image &image : images) {
        result.alternatives.push_back({image.why, units.fromFit(image.fit.parameters)});
    }
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        if (best.fit.noise[k] > 0.0) {
            result.noise.push_back(
                {problem.columns[k].channel, std::sqrt(best.fit.noise[k]) / units.factor(problem.columns[k].channel)});
        }
    }
    result.outcome = Outcome::Identified;
    for (const Candidate &rival : candidates.subspan(1)) {
        // The plain reading goes before the same with another origin, unless that tells of another mechanism and is
        // met by more than chance the better.
        constexpr double kMoreThanChance = 12.0;
        const bool isExtension = isSameButForZeros(rival.reading, best.reading) && rival.reading != best.reading;
        const bool isAsGood = isExtension ? rival.fit.deviance < best.fit.deviance - kMoreThanChance
                                          : rival.score() < best.score() + kMargin;
        if (rival.standing.stands && isAsGood &&
            isAnother(best.fit.parameters, uncertainty.standardError, rival.fit.parameters)) {
            result.outcome = Outcome::Ambiguous;
            result.alternatives.push_back({Why::AnotherMechanism, units.fromFit(rival.fit.parameters)});
        }
    }
    if (const double more = aliasDistanceOf(rows.all, best.fit); more > 0.0) {
        result.outcome = Outcome::Ambiguous;
        // The next one: another whole turn between two instants, the other way round.
        Parameters alias = chosen.parameters;
        alias.omega2 += alias.omega2 > 0.0 ? -more : more;
        alias.theta20 += (chosen.parameters.omega2 - alias.omega2) * rows.all.time.front();
        result.alternatives.push_back({Why::Alias, units.fromFit(alias)});
    }
    return result;
}

} // namespace slidercrank
