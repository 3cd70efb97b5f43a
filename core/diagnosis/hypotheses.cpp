// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnosis/hypotheses.h"

#include "core/diagnosis/unit_and_sense.h"
#include "core/identification/motion_start.h"

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

constexpr double kPriceOfCause = 20.0;
constexpr double kPriceOfColumn = 4.0;
constexpr double kPriceOfHalfTurn = 14.0; // half a turn must beat a free zero point of 180.0°

constexpr std::array<double, 2> kAngleFactors{kDegreesPerRadian, 1.0 / kDegreesPerRadian};
/// Ratios of mm, cm, m, in.
constexpr std::array<double, 12> kLengthFactors{10.0,       1e3,       25.4,       1e2,       1e3 / 25.4, 2.54,
                                                1.0 / 10.0, 1.0 / 1e3, 1.0 / 25.4, 1.0 / 1e2, 25.4 / 1e3, 1.0 / 2.54};

/// A column that is farther off than that, as part of its spread, is not explained.
constexpr double kExplained = 0.1;

/// A start is no better known than that: what is met so well is met, and needs no other reading.
constexpr double kMet = 0.01;

bool hasOrigin(Channel channel)
{
    return channel.order == Order::Position && (channel.coordinate == R4x || channel.coordinate == R4y ||
                                                channel.coordinate == Theta2 || channel.coordinate == Theta3);
}

double timeFactor(double timeUnit, Channel channel)
{
    return powerOf(timeUnit, channel);
}

/// A column against a channel of a model, in author's units.
class Match
{
public:
    Match(const ObservedColumn &column, Channel channel, std::span<const double> model)
        : m_column(column)
        , m_channel(channel)
        , m_model(model)
    {
        for (std::size_t i = 0; i < model.size(); ++i) {
            const double y = column.values[i];
            const double m = model[i];
            if (!std::isnan(y)) {
                m_n += 1.0;
                m_y += y;
                m_m += m;
                m_yy += y * y;
                m_mm += m * m;
                m_my += m * y;
            }
        }
        const double modelSpread = std::sqrt(std::max(m_mm / m_n - m_m * m_m / (m_n * m_n), 0.0));
        m_modelSpread = modelSpread;
        m_size = std::max(column.spread, column.varies ? 0.0 : 0.05 * std::sqrt(m_mm / m_n));
    }

    /// n ln(mean r² / spread²); 0 where that is not explained.
    double score(double factor, bool isTurned, bool isZeroFree) const
    {
        double mean = 0.0;
        if (isTurning(m_channel)) {
            // Without turns anything is an angle: only what varies as the model does.
            const double ratio = std::abs(factor) * m_column.spread / m_modelSpread;
            if (m_channel.coordinate != Theta2 && !(ratio > 0.5 && ratio < 2.0)) {
                return 0.0;
            }
            mean = meanOfTurning(factor, isTurned, isZeroFree);
        } else {
            const double sum = m_m - factor * m_y;
            const double squares = m_mm - 2.0 * factor * m_my + factor * factor * m_yy;
            mean = (squares - (isZeroFree ? sum * sum / m_n : 0.0)) / m_n;
        }
        const double size = std::abs(factor) * m_size;
        const double part = std::max(mean / (size * size), kMet * kMet);
        return part < kExplained * kExplained ? m_n * std::log(part) : 0.0;
    }

    double count() const { return m_n; }
    double bestFactor() const { return m_yy > 0.0 ? m_my / m_yy : 0.0; }
    double bestFactorAboutMeans() const
    {
        const double yy = m_yy - m_y * m_y / m_n;
        return yy > 0.0 ? (m_my - m_m * m_y / m_n) / yy : 0.0;
    }

    double correlation() const
    {
        const double yy = m_yy - m_y * m_y / m_n;
        const double mm = m_mm - m_m * m_m / m_n;
        return (m_my - m_m * m_y / m_n) / std::sqrt(std::max(yy * mm, 1e-300));
    }

private:
    double meanOfTurning(double factor, bool isTurned, bool isZeroFree) const
    {
        const double turn = isTurned ? 180.0 : 0.0;
        double first = kNone;
        double sum = 0.0;
        double squares = 0.0;
        for (std::size_t i = 0; i < m_model.size(); ++i) {
            if (std::isnan(m_column.values[i])) {
                continue;
            }
            double residual = factor * m_column.values[i] + turn - m_model[i];
            if (isZeroFree) {
                first = std::isnan(first) ? residual : first;
                residual -= first;
            }
            residual -= 360.0 * std::nearbyint(residual / 360.0);
            sum += residual;
            squares += residual * residual;
        }
        return (squares - (isZeroFree ? sum * sum / m_n : 0.0)) / m_n;
    }

    const ObservedColumn &m_column;
    Channel m_channel;
    std::span<const double> m_model;
    double m_n = 0.0, m_y = 0.0, m_m = 0.0, m_yy = 0.0, m_mm = 0.0, m_my = 0.0;
    double m_modelSpread = 0.0;
    double m_size = 0.0;
};

struct Scored {
    ColumnHypothesis column;
    double score = 0.0; ///< n ln …, without prices
    double price = 0.0;

    double total() const { return score + price; }
};

/// The best way to read a column as a channel, and the plain ones with and without a free zero point.
struct Ways {
    Scored best;
    Scored plain;
    Scored shifted;
};

Ways waysOf(const ObservedColumn &column, Channel channel, std::span<const double> model, double timeUnit,
            std::size_t values)
{
    const Match match(column, channel, model);
    Ways ways;
    const bool canShift = hasOrigin(channel);
    const auto consider = [&](ColumnHypothesis one) {
        const double factor = one.sign * one.unit * (one.isPerSecond ? timeFactor(timeUnit, channel) : 1.0);
        Scored scored{one, match.score(factor, one.isTurned, one.isZeroFree), 0.0};
        const double perCause = kPriceOfCause + kPriceOfColumn;
        scored.price = (one.unit != 1.0 ? perCause : 0.0) + (one.sign < 0.0 ? perCause : 0.0) +
                       (one.isPerSecond ? kPriceOfColumn : 0.0) + (one.isTurned ? kPriceOfHalfTurn : 0.0) +
                       (one.isZeroFree ? priceOfZero(channel) + std::log(static_cast<double>(values)) : 0.0);
        return scored;
    };
    ways.plain = consider({channel});
    ways.shifted = ways.plain;
    if (canShift) {
        ColumnHypothesis shifted{channel};
        shifted.isZeroFree = true;
        ways.shifted = consider(shifted);
    }
    ways.best = ways.shifted.total() < ways.plain.total() ? ways.shifted : ways.plain;
    if (ways.plain.score <= 1.99 * match.count() * std::log(kMet)) {
        return ways;
    }
    const auto improve = [&](const ColumnHypothesis &one) {
        const Scored scored = consider(one);
        if (scored.score < 0.0 && scored.total() < ways.best.total()) {
            ways.best = scored;
        }
    };
    const auto improveInAllOrigins = [&](ColumnHypothesis one) {
        improve(one);
        if (canShift) {
            one.isZeroFree = true;
            improve(one);
        }
    };
    if (channel.order != Order::Position && timeUnit != 1.0) {
        ColumnHypothesis one{channel};
        one.isPerSecond = true;
        improve(one);
        one.sign = -1.0;
        improve(one);
    }
    if (isTurning(channel)) {
        for (const double unit : {1.0, kAngleFactors[0], kAngleFactors[1]}) {
            for (const double sign : {1.0, -1.0}) {
                for (const bool isTurned : {false, true}) {
                    ColumnHypothesis one{channel};
                    one.unit = unit;
                    one.sign = sign;
                    one.isTurned = isTurned && channel.coordinate == Theta3;
                    improveInAllOrigins(one);
                }
            }
        }
        return ways;
    }
    const std::span<const double> units =
        isAngle(channel.coordinate) ? std::span<const double>(kAngleFactors) : std::span<const double>(kLengthFactors);
    ColumnHypothesis negated{channel};
    negated.sign = -1.0;
    improveInAllOrigins(negated);
    constexpr double kNear = 0.05;
    const std::array<double, 2> factors{match.bestFactor(), match.bestFactorAboutMeans()};
    for (const double unit : units) {
        for (const bool isPerSecond : {false, true}) {
            if (isPerSecond && (timeUnit == 1.0 || channel.order == Order::Position)) {
                continue;
            }
            const double whole = unit * (isPerSecond ? timeFactor(timeUnit, channel) : 1.0);
            for (const double factor : factors) {
                if (std::abs(std::abs(factor) / whole - 1.0) <= kNear) {
                    ColumnHypothesis one{channel};
                    one.unit = unit;
                    one.sign = factor < 0.0 ? -1.0 : 1.0;
                    one.isPerSecond = isPerSecond;
                    improveInAllOrigins(one);
                }
            }
        }
    }
    return ways;
}

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
        const Match match(column, column.channel, model);
        constexpr double kAlike = 0.95;
        if (std::abs(match.correlation()) < kAlike) {
            continue;
        }
        const double scale = std::abs(1.0 / match.bestFactorAboutMeans());
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
                const Match match(few.columns[k], few.columns[k].channel, models[k]);
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
        const double perTime = column.isPerSecond ? timeFactor(timeUnit, column.channel) : 1.0;
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
        for (Parameters image : imagesOf(start)) {
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
    InstantMotion motion;
    for (const FitColumn &column : problem.columns) {
        if (!isTurning(column.channel)) {
            continue;
        }
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
                    std::round((motion.valueOf(column.channel) + zero + turn - column.values[row]) / std::numbers::pi);
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
