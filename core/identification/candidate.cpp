// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/candidate.h"

#include "core/identification/motion_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace slidercrank
{

namespace
{

constexpr std::size_t kFewRows = 72;
constexpr std::size_t kFewestRows = 24;
constexpr int kRounds = 12;
constexpr int kScreeningRounds = 5;

bool hasLengths(const Observations &observations)
{
    return std::ranges::any_of(observations.columns, [](const ObservedColumn &column) {
        return !isAngle(column.channel.coordinate) && column.channel.coordinate != R4y && column.varies;
    });
}

double priceOf(const Candidate &candidate)
{
    return candidate.fit.parameters.branch == Branch::Crossed ? kPriceOfCrossed : 0.0;
}

} // namespace

bool isBetter(const Candidate &x, const Candidate &y)
{
    return x.standing.stands != y.standing.stands ? x.standing.stands : x.score() < y.score();
}

SearchRows searchRowsOf(const ReferenceData &data, const Clock &clock, std::span<const std::size_t> rows,
                        const Parameters &given)
{
    const FitUnits units = unitsFor(data, rows, given.a);
    // With gaps, few rows may hold nothing of a column: then it takes more.
    const auto thinnedTo = [&](std::size_t most, const Observations &more) {
        if (rows.size() <= most) {
            return more;
        }
        Observations few = observe(data, clock, units, thinned(rows, most));
        return std::ranges::equal(few.columns, more.columns, {}, &ObservedColumn::channel, &ObservedColumn::channel)
                   ? few
                   : more;
    };
    SearchRows result{observe(data, clock, units, rows), {}, {}, units.toFit(given), kAllFree};
    result.few = thinnedTo(kFewRows, result.all);
    result.fewest = thinnedTo(kFewestRows, result.few);
    if (result.few.columns.size() != result.all.columns.size()) { // gaps everywhere: few rows miss a column
        result.few = result.all;
    }
    result.isFree[indexOf(Parameter::A)] = hasLengths(result.all);
    return result;
}

Candidate candidateFrom(const SearchRows &rows, const FileReading &reading, double penalty, const Parameters &start,
                        const std::stop_token &stop)
{
    Candidate candidate{reading, penalty, false, rows.isFree, {}, {}, 1.0};
    FitProblem problem = problemOf(rows.all, reading);
    candidate.fit = fit(problem, start, rows.isFree, kRounds, stop);
    candidate.standing = standingOf(problem, candidate.fit);
    if (problem.clockStep > 0.0) {
        problem.clockStep = 0.0;
        Candidate exact = candidate;
        exact.isClockExact = true;
        exact.fit = fit(problem, candidate.fit.exists() ? candidate.fit.parameters : start, rows.isFree, kRounds, stop);
        exact.standing = standingOf(problem, exact.fit);
        if (isBetter(exact, candidate)) {
            candidate = exact;
        }
    }
    candidate.penalty += priceOf(candidate);
    candidate.distance = distanceOf(problem, candidate.fit);
    return candidate;
}

std::vector<Candidate> bestCandidates(const SearchRows &rows, const FileReading &reading, double penalty,
                                      std::span<const Parameters> starts, const std::stop_token &stop)
{
    constexpr std::size_t kMostRanked = 32;
    constexpr std::size_t kMostFits = 6;
    constexpr std::size_t kMostFullFits = 3;
    constexpr double kNear = 60.0; // of score on few rows: no rival comes from farther away
    const FitProblem few = problemOf(rows.few, reading);
    if (few.columns.empty()) {
        return {};
    }
    struct Ranked {
        double misfit;
        Parameters parameters;
    };
    std::vector<Ranked> ranked;
    const FitProblem fewest = problemOf(rows.fewest, reading);
    for (const Parameters &start : distinct(starts)) {
        for (Parameters image : mirrorImages(start)) {
            lengthenCoupler(few, image);
            const double misfit = misfitOf(fewest, image);
            if (std::isfinite(misfit)) {
                ranked.push_back({misfit, image});
            }
        }
    }
    std::ranges::stable_sort(ranked, {}, &Ranked::misfit);
    ranked.resize(std::min(ranked.size(), kMostRanked));
    for (Ranked &one : ranked) {
        one.misfit = misfitOf(few, one.parameters);
    }
    std::ranges::stable_sort(ranked, {}, &Ranked::misfit);

    struct Fitted {
        Fit fit;
        bool isExact;
    };
    std::vector<Fitted> fitted;
    std::size_t fits = 0;
    for (std::size_t i = 0; i < ranked.size() && fits < kMostFits && !stop.stop_requested(); ++i) {
        // The same place again, from another route?
        const bool isKnown =
            std::any_of(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(i), [&](const Ranked &other) {
                return isSameMechanism(other.parameters, ranked[i].parameters) &&
                       std::abs(other.misfit - ranked[i].misfit) < 1e-3 * std::abs(ranked[i].misfit);
            });
        if (isKnown) {
            continue;
        }
        ++fits;
        const Fit found = fit(few, ranked[i].parameters, rows.isFree, kScreeningRounds, stop);
        if (!found.exists()) {
            continue;
        }
        const bool isDouble = std::ranges::any_of(fitted, [&](const Fitted &other) {
            return isSameMechanism(other.fit.parameters, found.parameters) &&
                   std::abs(other.fit.score - found.score) < 1.0;
        });
        if (isDouble) {
            continue;
        }
        const bool isExact = std::ranges::all_of(found.noise, [](double noise) { return noise == 0.0; });
        fitted.push_back({found, isExact});
        constexpr double kTwoDigits = -9.0; // a value, in the score
        if (isExact && found.score < kTwoDigits * static_cast<double>(few.valueCount)) {
            break; // no other mechanism meets all of them as well
        }
    }
    std::ranges::stable_sort(fitted, {}, [](const Fitted &one) { return one.fit.score; });
    std::vector<Candidate> candidates;
    for (const Fitted &one : fitted) {
        if (candidates.size() == kMostFullFits || one.fit.score > fitted.front().fit.score + kNear) {
            break;
        }
        candidates.push_back(candidateFrom(rows, reading, penalty, one.fit.parameters, stop));
    }
    std::ranges::stable_sort(candidates, {}, &Candidate::score);
    return candidates;
}

FileReading withFreeZeros(const Observations &observations, FileReading reading)
{
    for (std::size_t i = 0; i < reading.size(); ++i) {
        const Channel channel = reading[i].channel;
        const bool isOrigin =
            channel.order == Order::Position && (channel.coordinate == R4x || channel.coordinate == R4y ||
                                                 channel.coordinate == Theta2 || channel.coordinate == Theta3);
        // A constant R4y is c, whatever it is counted from, unless something else tells c; and what is alone has no
        // other origin to differ from.
        if (isOrigin && observations.columns[i].count > 1) {
            reading[i].isZeroFree = true;
        }
    }
    return reading;
}

Candidate withoutIdleZeros(const SearchRows &rows, Candidate candidate, const std::stop_token &stop)
{
    for (;;) {
        std::optional<Candidate> best;
        for (std::size_t i = 0; i < candidate.reading.size(); ++i) {
            if (!candidate.reading[i].isZeroFree || stop.stop_requested()) {
                continue;
            }
            FileReading reading = candidate.reading;
            reading[i].isZeroFree = false;
            const double penalty = candidate.penalty - priceOf(candidate) - priceOfZero(reading[i].channel);
            Candidate without = candidateFrom(rows, reading, penalty, candidate.fit.parameters, stop);
            const bool isAllowed = without.standing.stands || !candidate.standing.stands;
            if (isAllowed && without.score() < candidate.score() && (!best || without.score() < best->score())) {
                best = std::move(without);
            }
        }
        if (!best) {
            return candidate;
        }
        candidate = std::move(*best);
    }
}

std::vector<Candidate> plainCandidates(const SearchRows &rows, std::span<const Parameters> starts,
                                       const std::stop_token &stop)
{
    const FileReading plain = asWritten(rows.all);
    std::vector<Candidate> candidates = bestCandidates(rows, plain, 0.0, starts, stop);
    const FileReading shifted = withFreeZeros(rows.all, plain);
    double spent = 0.0;
    for (const ColumnReading &column : shifted) {
        spent += column.isZeroFree ? priceOfZero(column.channel) : 0.0;
    }
    // Where rounding explains all, a free constant has nothing to gain but what it costs.
    const bool isDone = !candidates.empty() && candidates.front().standing.isExact &&
                        candidates.front().standing.stands &&
                        candidates.front().fit.chiSquared <
                            static_cast<double>(rows.all.valueCount()) + priceOfZero({Theta3, Order::Position});
    if (spent > 0.0 && !isDone) {
        std::vector<Candidate> others = bestCandidates(rows, shifted, spent, starts, stop);
        for (Candidate &other : others) {
            const bool isFirst = &other == &others.front();
            if (isFirst || other.standing.stands) {
                candidates.push_back(withoutIdleZeros(rows, other, stop));
            }
            if (isFirst && other.standing.stands && candidates.back().reading != other.reading) {
                candidates.push_back(std::move(other)); // dearer, but perhaps telling of another mechanism
            }
        }
    }
    std::ranges::stable_sort(candidates, isBetter);
    return candidates;
}

} // namespace slidercrank
