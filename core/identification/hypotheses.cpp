// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/hypotheses.h"

#include "core/identification/crank_speed.h"
#include "core/identification/motion_start.h"
#include "core/identification/unit_and_sense.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

double screeningOf(const std::vector<Scored> &columns)
{
    double sum = 0.0;
    for (const Scored &one : columns) {
        sum += one.column.isUsed ? one.score : 0.0;
    }
    return sum;
}

struct Screened {
    Hypothesis hypothesis;
    double total = 0.0;
};

/// All that one mechanism makes of the columns. False where the derivatives are explained as they are: then they are in
/// no other unit of time.
bool explainBy(const Observations &few, const Parameters &start, double timeUnit, std::vector<Screened> &found)
{
    const std::size_t rows = few.time.size();
    std::vector<std::vector<double>> models(few.columns.size(), std::vector<double>(rows));
    InstantMotion motion;
    for (std::size_t row = 0; row < rows; ++row) {
        if (!motion.computeValues(start, few.time[row])) {
            return false;
        }
        for (std::size_t k = 0; k < models.size(); ++k) {
            const Channel channel = few.columns[k].channel;
            models[k][row] = motion.valueOf(channel) / few.units.factor(channel);
        }
    }
    const std::size_t values = few.valueCount();
    std::vector<Scored> best;
    std::vector<Scored> plain;
    std::vector<Scored> shifted;
    for (std::size_t k = 0; k < models.size(); ++k) {
        const Ways ways = waysOf(few.columns[k], few.columns[k].channel, models[k], timeUnit, values);
        best.push_back(ways.best);
        plain.push_back(ways.plain);
        shifted.push_back(ways.shifted);
    }
    const auto keep = [&](const std::vector<Scored> &columns) {
        // What is to stand must be near to most columns from the start.
        const auto misled =
            std::ranges::count_if(columns, [](const Scored &one) { return one.column.isUsed && one.score == 0.0; });
        if (3 * static_cast<std::size_t>(misled) > columns.size()) {
            return;
        }
        Hypothesis hypothesis;
        hypothesis.start = start;
        bool usesTime = false;
        for (const Scored &one : columns) {
            hypothesis.columns.push_back(one.column);
            usesTime = usesTime || one.column.isPerSecond;
        }
        hypothesis.timeUnit = usesTime ? timeUnit : 1.0;
        found.push_back({hypothesis, screeningOf(columns) + hypothesis.price(few)});
    };
    const auto keepAlsoWithoutBadDerivatives = [&](std::vector<Scored> columns) {
        keep(columns);
        std::size_t left = 0;
        for (Scored &one : columns) {
            if (one.score == 0.0 && one.column.channel.order != Order::Position && isPlotted(one.column.channel)) {
                one.column = {one.column.channel};
                one.column.isUsed = false;
                ++left;
            }
        }
        if (left > 0 && 2 * left <= columns.size()) {
            keep(columns);
        }
    };
    if (timeUnit == 1.0) {
        keep(plain);
        keep(shifted);
    }
    keepAlsoWithoutBadDerivatives(best);
    // Two columns under each other's names.
    double gain = -(kPriceOfCause + 2.0 * kPriceOfColumn);
    std::vector<Scored> swapped;
    for (std::size_t i = 0; i < best.size(); ++i) {
        for (std::size_t j = i + 1; j < best.size(); ++j) {
            if (!isPlotted(few.columns[i].channel) || !isPlotted(few.columns[j].channel) || plain[i].score < 0.0 ||
                plain[j].score < 0.0) {
                continue;
            }
            const Ways one = waysOf(few.columns[i], few.columns[j].channel, models[j], timeUnit, values);
            const Ways other = waysOf(few.columns[j], few.columns[i].channel, models[i], timeUnit, values);
            const double change = one.plain.total() + other.plain.total() - best[i].total() - best[j].total();
            if (one.plain.score < 0.0 && other.plain.score < 0.0 && change < gain) {
                gain = change;
                swapped = best;
                swapped[i] = one.plain;
                swapped[j] = other.plain;
            }
        }
    }
    if (!swapped.empty()) {
        keepAlsoWithoutBadDerivatives(swapped);
    }
    return std::ranges::any_of(
        plain, [](const Scored &one) { return one.column.channel.order != Order::Position && one.score == 0.0; });
}

/// The mechanism in the sizes that single columns of length have: together they may be in different units.
std::vector<Parameters> sizesOf(const Observations &few, const Parameters &start)
{
    std::vector<Parameters> sizes{start};
    std::vector<double> scales{1.0};
    InstantMotion motion;
    std::vector<double> model(few.time.size());
    for (const ObservedColumn &column : few.columns) {
        if (isAngle(column.channel.coordinate) || !column.varies) {
            continue;
        }
        for (std::size_t row = 0; row < model.size(); ++row) {
            if (!motion.computeValues(start, few.time[row])) {
                return sizes;
            }
            model[row] = motion.valueOf(column.channel) / few.units.factor(column.channel);
        }
        const ColumnMatch match(column, column.channel, model);
        constexpr double kAlike = 0.95;
        if (std::abs(match.correlation()) < kAlike) {
            continue;
        }
        const double scale = std::abs(1.0 / match.factorAboutMeans());
        constexpr double kSame = 1.003;
        const bool isKnown =
            std::ranges::any_of(scales, [&](double other) { return scale < kSame * other && other < kSame * scale; });
        if (std::isfinite(scale) && scale > 0.0 && !isKnown) {
            scales.push_back(scale);
            Parameters one = start;
            one.a *= scale;
            one.b *= scale;
            one.c *= scale;
            sizes.push_back(one);
        }
    }
    return sizes;
}

/// The starts whose motion is most like the columns, whatever their units, signs and origins: correlations do not
/// change with these, nor from one image to the next.
std::vector<Parameters> likeliest(const Observations &few, std::span<const Parameters> starts)
{
    constexpr std::size_t kMost = 8;
    struct Ranked {
        double distance;
        Parameters start;
    };
    std::vector<Ranked> ranked;
    const FitProblem problem = problemOf(few, asWritten(few));
    for (Parameters start : distinct(starts)) {
        lengthenCoupler(problem, start);
        std::vector<std::vector<double>> models(few.columns.size(), std::vector<double>(few.time.size()));
        InstantMotion motion;
        bool moves = true;
        for (std::size_t row = 0; row < few.time.size() && moves; ++row) {
            moves = motion.computeValues(start, few.time[row]);
            for (std::size_t k = 0; moves && k < models.size(); ++k) {
                models[k][row] = motion.valueOf(few.columns[k].channel);
            }
        }
        if (!moves) {
            continue;
        }
        double distance = 0.0;
        for (std::size_t k = 0; k < models.size(); ++k) {
            if (few.columns[k].varies) {
                const ColumnMatch match(few.columns[k], few.columns[k].channel, models[k]);
                const double correlation = match.correlation();
                distance += match.count() * std::log(std::max(1.0 - correlation * correlation, 1e-9));
            }
        }
        ranked.push_back({distance, start});
    }
    std::ranges::stable_sort(ranked, {}, &Ranked::distance);
    std::vector<Parameters> best;
    for (const Ranked &one : ranked) {
        if (best.size() == kMost) {
            break;
        }
        best.push_back(one.start);
    }
    return best;
}

/// The same ways of reading, whatever the mechanism.
bool readsAlike(const Hypothesis &x, const Hypothesis &y)
{
    return x.columns == y.columns && x.timeUnit == y.timeUnit;
}

} // namespace

Hypothesis plainHypothesis(const Observations &observations)
{
    Hypothesis hypothesis;
    for (const ObservedColumn &column : observations.columns) {
        hypothesis.columns.push_back({column.channel});
    }
    return hypothesis;
}

FileReading Hypothesis::reading() const
{
    FileReading reading;
    for (const ColumnHypothesis &column : columns) {
        const double perTime = column.isPerSecond ? powerOf(timeUnit, column.channel) : 1.0;
        reading.push_back({column.channel, column.sign * column.unit * perTime, column.isTurned ? 180.0 : 0.0,
                           column.isUsed, column.isZeroFree});
    }
    return reading;
}

double Hypothesis::price(const Observations &observations) const
{
    // Of one kind and amount, angles and lengths apart: how many columns. All of them are one cause.
    std::map<std::tuple<Kind, double, bool>, std::size_t> causes;
    double price = 0.0;
    bool isTimed = false;
    std::size_t perFileTime = 0;
    const auto add = [&](Kind kind, double amount, bool isOfAngle) { ++causes[{kind, amount, isOfAngle}]; };
    std::array<std::size_t, 2> counts{};
    for (const ColumnHypothesis &column : columns) {
        const bool isConstant = column.channel.coordinate == R4y || column.channel.coordinate == Theta2;
        counts[isAngle(column.channel.coordinate) ? 1 : 0] += isConstant ? 0 : 1;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const ColumnHypothesis &column = columns[i];
        const bool isOfAngle = isAngle(column.channel.coordinate);
        if (!column.isUsed) {
            add(Kind::NotDerivative, 0.0, false);
            continue;
        }
        if (column.unit != 1.0) {
            add(isOfAngle ? Kind::AngleUnit : Kind::LengthUnit, column.unit, isOfAngle);
        }
        if (column.sign < 0.0) {
            add(Kind::Sign, -1.0, isOfAngle);
        }
        if (column.isPerSecond) {
            isTimed = true;
        } else if (column.channel.order != Order::Position) {
            ++perFileTime;
        }
        if (column.isTurned) {
            price += kPriceOfHalfTurn;
        }
        if (column.channel != observations.columns[i].channel) {
            add(Kind::SwappedColumns, 0.0, false);
        }
        if (column.isZeroFree) {
            price += priceOfZero(column.channel);
        }
    }
    for (const auto &[cause, count] : causes) {
        const auto [kind, amount, isOfAngle] = cause;
        const bool isWhole = (kind == Kind::Sign || kind == Kind::AngleUnit || kind == Kind::LengthUnit) && count > 1 &&
                             count >= counts[isOfAngle ? 1 : 0];
        price += kPriceOfCause + kPriceOfColumn * static_cast<double>(isWhole ? 1 : count);
    }
    return price + (isTimed ? kPriceOfCause + kPriceOfColumn * static_cast<double>(1 + perFileTime) : 0.0);
}

std::vector<Hypothesis> hypothesesFrom(const Observations &few, std::span<const Parameters> starts,
                                       const std::stop_token &stop)
{
    constexpr std::size_t kMost = 8;
    constexpr std::size_t kMostAlike = 2;
    const FitProblem problem = problemOf(few, asWritten(few));
    std::vector<Screened> screened;
    for (const Parameters &start : likeliest(few, starts)) {
        for (Parameters image : mirrorImages(start)) {
            if (stop.stop_requested()) {
                return {};
            }
            lengthenCoupler(problem, image);
            for (const Parameters &sized : sizesOf(few, image)) {
                if (explainBy(few, sized, 1.0, screened)) {
                    for (const double timeUnit : kTimeUnits) {
                        explainBy(few, sized, timeUnit, screened);
                    }
                }
            }
        }
    }
    std::ranges::stable_sort(screened, {}, &Screened::total);
    std::vector<Hypothesis> best;
    for (const Screened &one : screened) {
        const auto alike = static_cast<std::size_t>(
            std::ranges::count_if(best, [&](const Hypothesis &other) { return readsAlike(one.hypothesis, other); }));
        const bool isKnown = std::ranges::any_of(best, [&](const Hypothesis &other) {
            return readsAlike(one.hypothesis, other) && isSameMechanism(one.hypothesis.start, other.start) &&
                   one.hypothesis.start.branch == other.start.branch &&
                   one.hypothesis.start.omega2 * other.start.omega2 > 0.0;
        });
        if (!isKnown && alike < kMostAlike) {
            best.push_back(one.hypothesis);
        }
        if (best.size() == kMost) {
            break;
        }
    }
    return best;
}

std::vector<Parameters> startsFromParts(const Observations &observations, double size, const std::stop_token &stop)
{
    std::vector<Parameters> starts;
    // The speed is the same in whatever unit and under whatever name: looked for once.
    std::map<std::vector<bool>, std::vector<double>> speeds;
    const auto addFrom = [&](const FileReading &reading) {
        std::vector<bool> used;
        for (const ColumnReading &column : reading) {
            used.push_back(column.isUsed);
        }
        const auto [known, isNew] = speeds.try_emplace(used);
        if (isNew) {
            known->second = speedsOf(problemOf(observations, reading), stop);
        }
        // What does not even explain its own part explains nothing.
        const FitProblem part = problemOf(observations, withFreeZeros(observations, reading));
        const double most = static_cast<double>(part.valueCount) * 2.0 * std::log(kExplained);
        constexpr std::size_t kMostOfAPart = 3;
        std::vector<std::pair<double, Parameters>> ranked;
        for (const Parameters &start :
             distinct(startsOf(problemOf(observations, reading), known->second, size, stop))) {
            const double misfit = misfitOf(part, start);
            if (misfit < most) {
                ranked.emplace_back(misfit, start);
            }
        }
        std::ranges::stable_sort(ranked, {}, [](const auto &one) { return one.first; });
        for (std::size_t i = 0; i < std::min(ranked.size(), kMostOfAPart); ++i) {
            starts.push_back(ranked[i].second);
        }
    };
    const auto only = [&](auto &&isMeant) {
        FileReading reading = asWritten(observations);
        std::size_t used = 0;
        for (std::size_t i = 0; i < reading.size(); ++i) {
            reading[i].isUsed = isMeant(i, reading[i]);
            used += reading[i].isUsed ? 1 : 0;
        }
        if (used > 0) {
            addFrom(reading);
        }
        return used;
    };
    for (const Coordinate family : {Theta3, R4x}) {
        for (const double unit : {1.0, kAngleFactors[0], kAngleFactors[1]}) {
            if (family == R4x && unit != 1.0) {
                continue;
            }
            only([&](std::size_t, ColumnReading &reading) {
                reading.factor = unit;
                return reading.channel.coordinate == family;
            });
        }
    }
    for (std::size_t k = 0; k < observations.columns.size(); ++k) {
        const Channel channel = observations.columns[k].channel;
        if (!isPlotted(channel)) {
            continue;
        }
        only([&](std::size_t i, ColumnReading &) { return i == k; });
        if (isAngle(channel.coordinate)) {
            for (const double unit : kAngleFactors) {
                only([&](std::size_t i, ColumnReading &reading) {
                    reading.factor = unit;
                    return i == k;
                });
            }
        }
        // Under another's name.
        only([&](std::size_t i, ColumnReading &reading) {
            reading.channel.coordinate = channel.coordinate == R4x ? Theta3 : R4x;
            return i == k;
        });
    }
    return starts;
}

std::vector<Convention> conventionsOf(const Observations &observations, const Hypothesis &hypothesis,
                                      const Candidate &candidate)
{
    std::vector<Convention> conventions;
    const auto add = [&](Kind kind, double amount, Channel channel) {
        for (Convention &one : conventions) {
            if (one.kind == kind && one.amount == amount &&
                (kind != Kind::Sign || isAngle(one.channels.front().coordinate) == isAngle(channel.coordinate))) {
                one.channels.push_back(channel);
                return;
            }
        }
        conventions.push_back({kind, {channel}, amount});
    };
    if (hypothesis.timeUnit != 1.0) {
        Convention time{Kind::TimeUnit, {}, hypothesis.timeUnit};
        for (const ColumnHypothesis &column : hypothesis.columns) {
            if (column.isUsed && column.channel.order != Order::Position && !column.isPerSecond) {
                time.channels.push_back(column.channel); // counts in the file's unit, too
            }
        }
        conventions.push_back(time);
    }
    for (std::size_t i = 0; i < hypothesis.columns.size(); ++i) {
        const Channel name = observations.columns[i].channel;
        const Channel content = hypothesis.columns[i].channel;
        if (indexOf(name) < indexOf(content)) {
            conventions.push_back({Kind::SwappedColumns, {name, content}, 1.0});
        }
    }
    for (std::size_t i = 0; i < hypothesis.columns.size(); ++i) {
        const ColumnHypothesis &column = hypothesis.columns[i];
        if (column.isUsed && column.unit != 1.0) {
            add(isAngle(column.channel.coordinate) ? Kind::AngleUnit : Kind::LengthUnit, column.unit, column.channel);
        }
    }
    for (const ColumnHypothesis &column : hypothesis.columns) {
        if (column.isUsed && column.sign < 0.0) {
            add(Kind::Sign, -1.0, column.channel);
        }
    }
    const FitProblem problem = problemOf(observations, candidate.reading);
    // The fit counts its time from an instant within the file, and θ20 from that of the mechanism by whole turns.
    const Parameters &fitted = candidate.fit.parameters;
    const Parameters whole = observations.units.fromFit(fitted);
    const double counted = std::round((fitted.theta20 - whole.omega2 * observations.units.origin - whole.theta20) /
                                      (2.0 * std::numbers::pi));
    InstantMotion motion;
    for (const FitColumn &column : problem.columns) {
        if (!isTurning(column.channel)) {
            continue;
        }
        const double halfTurnsCounted = column.channel.coordinate == Theta2 ? 2.0 * counted : 0.0;
        // The column as it is, against the model: off by half turns, or with jumps.
        const ColumnHypothesis &how = hypothesis.columns[column.source];
        const double zero = column.zero >= 0 ? candidate.fit.zeros[static_cast<std::size_t>(column.zero)] : 0.0;
        const double turn = how.isTurned ? std::numbers::pi : 0.0;
        double least = std::numeric_limits<double>::infinity();
        double most = -least;
        double first = kNone;
        for (std::size_t row = 0; row < problem.time.size(); ++row) {
            if (!std::isnan(column.values[row]) && motion.computeValues(candidate.fit.parameters, problem.time[row])) {
                const double off =
                    std::round((motion.valueOf(column.channel) + zero + turn - column.values[row]) / std::numbers::pi) -
                    halfTurnsCounted;
                first = std::isnan(first) ? off : first;
                least = std::min(least, off);
                most = std::max(most, off);
            }
        }
        const double amount = 180.0 * first;
        const bool isHalf = std::remainder(first, 2.0) != 0.0;
        if (isHalf || first != 0.0 || least != most || observations.columns[column.source].hasJumps) {
            add(isHalf ? Kind::HalfTurn : Kind::WholeTurns, amount, column.channel);
        }
    }
    for (const FitColumn &column : problem.columns) {
        if (column.zero >= 0) {
            const double zero = candidate.fit.zeros[static_cast<std::size_t>(column.zero)];
            // So small a constant takes up what else is not quite right, and is no origin.
            const double leastOrigin = candidate.standing.isExact ? 1e-3 : 2e-2;
            const double size = column.channel.coordinate == R4y ? candidate.fit.parameters.a : column.spread;
            if (std::abs(zero) < std::max(leastOrigin * size, column.step)) {
                continue;
            }
            conventions.push_back(
                {Kind::ZeroPoint, {column.channel}, -zero / observations.units.factor(column.channel) + 0.0});
        }
    }
    Convention none{Kind::NotDerivative, {}, 1.0};
    for (const ColumnHypothesis &column : hypothesis.columns) {
        if (!column.isUsed) {
            none.channels.push_back(column.channel);
        }
    }
    if (!none.channels.empty()) {
        conventions.push_back(none);
    }
    return conventions;
}

} // namespace slidercrank
