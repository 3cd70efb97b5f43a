// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/interpretation.h"

#include "core/identification/convention.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

constexpr std::array kAngleFactors{1.0, kDegreesPerRadian, 1.0 / kDegreesPerRadian};
constexpr std::array kLengthFactors{1.0, 10.0, 25.4, 1000.0, 0.1, 1.0 / 25.4, 1e-3};
constexpr std::array kTimeFactors{1.0, 1e-3, 1e3};

// Prices in units of the score: twice the negative logarithm of the prior odds against the plain interpretation.
constexpr double kPriceOfCause = 20.0;
constexpr double kPriceOfColumn = 4.0;
constexpr double kPriceOfHalfTurn = 14.0; // less than an offset, so that a half turn beats an offset of 180°
constexpr double kPriceOfDepth =
    10.0; // instead of kPriceOfCause: with another origin, R4x may also have the other direction
constexpr double kPriceOfCrossed = 6.0;   // breaks ties only
constexpr double kPriceOfOffset = 26.0;   // more than a sign, so that a sign beats an offset of twice the value
constexpr double kPriceOfParameter = 6.0; // about ln N

bool mayHaveOffset(Channel channel)
{
    return channel.order == Order::Position &&
           (channel.coordinate == R4x || channel.coordinate == R4y || channel.coordinate == Theta3);
}

template <std::size_t kCount>
double nearestFactor(const std::array<double, kCount> &factors, double wanted)
{
    return *std::ranges::min_element(factors, {},
                                     [&](double factor) { return std::abs(std::log(std::abs(wanted) / factor)); });
}

/// The price of the assumptions on the crank angle of a file by crank angle.
double priceOfAbscissa(const Observations &data, const Hypothesis &hypothesis)
{
    if (!data.isByCrankAngle) {
        return 0.0;
    }
    const double factor = hypothesis.abscissaFactor;
    return (factor < 0.0 ? kPriceOfCause + kPriceOfColumn : 0.0) +
           (std::abs(factor) != 1.0 ? kPriceOfCause + kPriceOfColumn : 0.0) +
           (hypothesis.isFree[indexOf(Parameter::Theta20)] ? kPriceOfCause : 0.0);
}

/// Chooses the unit and sign with which the column fits the model best.
void chooseUnit(const ObservedColumn &column, const ColumnRegression &regression, double size, ColumnUse &use)
{
    if (tellsShape(column)) {
        const double slope = regression.slope();
        const double wanted = slope != 0.0 ? size / slope / use.perTime / use.base : 1.0;
        use.unit = isLength(use.channel) ? nearestFactor(kLengthFactors, wanted) : nearestFactor(kAngleFactors, wanted);
        use.sign = wanted < 0.0 ? -1.0 : 1.0;
    } else if (use.channel == Channel{R4y, Order::Position}) {
        constexpr double kAbout = 0.1;
        const double model = size * regression.sumModel / regression.n;
        use.sign = std::abs(column.mean + model) < kAbout * std::abs(column.mean) ? -1.0 : 1.0;
    }
}

/// The square of the size with which a misfit of the column is compared.
double squaredSize(const ObservedColumn &column, const ColumnUse &use, double size, const Hypothesis &hypothesis)
{
    const double natural = column.channel.coordinate == R4y ? size * hypothesis.unknowns[0] : hypothesis.unknowns[3];
    const double spread = use.factor() * column.spread;
    return isConstantByNature(column.channel) ? natural * natural : spread * spread;
}

/// Interprets one column in the best allowed way and returns its misfit.
double interpretColumn(const ObservedColumn &column, const ColumnRegression &regression, double size,
                       const Hypothesis &hypothesis, Interpretations allowed, ColumnUse &use)
{
    constexpr double kResolution = 1e-10; // of the variance: the accuracy of a fitted shape
    constexpr double kExplained = 0.01;   // of the variance: a column with a larger misfit is not explained
    if (allowed == Interpretations::All) {
        chooseUnit(column, regression, size, use);
    }
    const double factor = use.factor();
    const double aboutMean = regression.meanSquare(factor, size) + factor * factor * column.meanVariance;
    double offset = regression.offset(factor, size);
    if (isAngle(use.channel.coordinate) && use.channel.order == Order::Position) {
        const bool wholeTurns = allowed == Interpretations::Plain || use.channel.coordinate == Theta2;
        const double part = wholeTurns ? kTurn : std::numbers::pi;
        use.turn = part * std::round(offset / part);
        offset -= use.turn;
    }
    const double size2 = squaredSize(column, use, size, hypothesis);
    const auto misfit = [&](double square) {
        return square > kExplained * size2 ? 0.0 : regression.n * std::log(square / size2 + kResolution);
    };
    double best = misfit(aboutMean + offset * offset);
    if (allowed != Interpretations::Plain && mayHaveOffset(column.channel)) {
        const double price = kPriceOfOffset + kPriceOfParameter - (use.isHalfTurned() ? kPriceOfHalfTurn : 0.0);
        if (misfit(aboutMean) + price < best) {
            use.hasOffset = true;
            use.turn -= use.isHalfTurned() ? std::numbers::pi : 0.0;
            best = misfit(aboutMean);
        }
    }
    if (allowed == Interpretations::All && best >= 0.0 && column.channel.order != Order::Position &&
        tellsShape(column)) {
        use = {column.channel};
        use.isUsed = false;
    }
    return best;
}

/// Chooses the best interpretation of each column. The lengths of the hypothesis are multiplied by `size` first.
/// Returns nullopt if more than half of the columns were left out, or if units of columns cancel the other unit of
/// time.
std::optional<Interpretation> interpret(const Observations &data, Hypothesis hypothesis,
                                        const std::vector<ColumnRegression> &regressions, double size,
                                        Interpretations allowed)
{
    Interpretation result{std::move(hypothesis), 0.0};
    std::size_t leftOut = 0;
    bool isOtherTime = result.hypothesis.timeUnit == 1.0; // or it converts some derivative
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        ColumnUse &use = result.hypothesis.columns[j];
        use.perTime = std::pow(result.hypothesis.timeUnit, static_cast<int>(use.channel.order));
        const double columnSize = isLength(use.channel) ? size : 1.0;
        if (regressions[j].n > 0.0) {
            result.misfit +=
                interpretColumn(data.columns[j], regressions[j], columnSize, result.hypothesis, allowed, use);
        }
        leftOut += use.isUsed ? 0 : 1;
        isOtherTime =
            isOtherTime || (use.isUsed && use.perTime != 1.0 && std::abs(use.unit * use.perTime - 1.0) > 1e-6);
    }
    result.misfit += priceOf(data, result.hypothesis);
    result.hypothesis.unknowns.head(3) *= size;
    return 2 * leftOut > data.columns.size() || !isOtherTime ? std::nullopt : std::optional(std::move(result));
}

/// Continuation from the fit with free scales and origins to the fit with those of the file, in small steps: on a short
/// arc the first is too far from the second.
std::optional<Hypothesis> continued(const Observations &data, Hypothesis hypothesis,
                                    const std::vector<ColumnRegression> &regressions, double size)
{
    constexpr int kSteps = 8;
    constexpr int kRounds = 3;
    constexpr double kLargestTurn = 1.5; // rad: largest offset from which continuation is tried
    hypothesis.unknowns.head(3) *= size;
    std::vector<double> factors;
    std::vector<double> offsets;
    for (std::size_t j = 0; j < regressions.size(); ++j) {
        const ObservedColumn &column = data.columns[j];
        const double columnSize = isLength(column.channel) ? size : 1.0;
        const bool counts = tellsShape(column);
        if (counts && !(regressions[j].slope() > 0.0)) {
            return std::nullopt;
        }
        factors.push_back(counts ? columnSize / regressions[j].slope() : 1.0);
        offsets.push_back(
            counts && column.channel.order == Order::Position ? regressions[j].offset(factors[j], columnSize) : 0.0);
        if (!isLength(column.channel) && std::abs(offsets[j]) > kLargestTurn) {
            return std::nullopt;
        }
    }
    for (int k = 1; k <= kSteps; ++k) {
        const double left = 1.0 - static_cast<double>(k) / kSteps;
        for (std::size_t j = 0; j < regressions.size(); ++j) {
            hypothesis.columns[j].unit = std::pow(factors[j], left);
            hypothesis.columns[j].turn = offsets[j] * left;
        }
        Fit fit = fitHypothesis(data, hypothesis, kRounds);
        if (!fit.exists()) {
            return std::nullopt;
        }
        hypothesis.unknowns = fit.hypothesis.unknowns;
    }
    return hypothesis;
}

/// Appends a value that differs from those in the list.
void addDistinct(double value, std::vector<double> &values)
{
    constexpr double kSame = 1e-3;
    if (value != 0.0 && std::isfinite(value) &&
        std::ranges::none_of(values, [&](double other) { return std::abs(other - value) < kSame * std::abs(value); })) {
        values.push_back(value);
    }
}

/// The sizes of the mechanism, relative to b = 1, that follow from each column of lengths. If there is none, holds a
/// and returns the size of the given mechanism.
std::vector<double> sizesToldBy(const Observations &data, const std::vector<ColumnRegression> &regressions,
                                const InterpretationOptions &options, Hypothesis &hypothesis)
{
    std::vector<double> sizes;
    bool hasLength = false;
    for (std::size_t j = 0; j < regressions.size(); ++j) {
        const ColumnUse &use = hypothesis.columns[j];
        if (tellsShape(data.columns[j]) && isLength(use.channel)) {
            hasLength = true;
            if (options.allowed == Interpretations::All || regressions[j].slope() > 0.0) {
                addDistinct(std::abs(regressions[j].slope()) * use.base, sizes);
            }
        }
    }
    hypothesis.isFree[indexOf(Parameter::A)] = hasLength;
    if (!hasLength) {
        sizes.push_back(options.given.a / std::abs(hypothesis.unknowns[0]));
    }
    return sizes;
}

/// The crank speeds that follow from the time derivatives in a file by crank angle, if ω2 = 1 in the hypothesis.
std::vector<double> speedsToldBy(const Observations &data, const std::vector<ColumnRegression> &regressions)
{
    std::vector<double> speeds;
    for (std::size_t j = 0; j < regressions.size(); ++j) {
        const Channel channel = data.columns[j].channel;
        if (channel == Channel{Theta2, Order::Velocity}) {
            addDistinct(data.columns[j].mean, speeds);
        }
        if (!tellsShape(data.columns[j]) || channel.order == Order::Position) {
            continue;
        }
        double size = 1.0; // of the position of the same coordinate
        for (std::size_t k = 0; k < regressions.size(); ++k) {
            const Channel other = data.columns[k].channel;
            if (isLength(channel) && isLength(other) && other.order == Order::Position && tellsShape(data.columns[k])) {
                size = std::abs(regressions[k].slope());
            }
        }
        const double ratio = regressions[j].slope() / size;
        if (channel.order == Order::Velocity) {
            addDistinct(ratio, speeds);
        } else {
            addDistinct(std::sqrt(std::abs(ratio)), speeds);
            addDistinct(-std::sqrt(std::abs(ratio)), speeds);
        }
    }
    return speeds;
}

/// The hypotheses on the crank angle of a file by crank angle: its origin as in the file or free, with each speed that
/// follows from the derivatives.
std::vector<Hypothesis> crankHypotheses(const Observations &data, const Hypothesis &hypothesis,
                                        const InterpretationOptions &options)
{
    constexpr double kAbout = 0.2; // rad
    constexpr std::size_t kOrigin = indexOf(Parameter::Theta20);
    constexpr std::size_t kSpeed = indexOf(Parameter::Omega2);
    const double plainAngle = hypothesis.abscissaFactor * data.origin;
    const double zero = std::remainder(hypothesis.unknowns[4] - plainAngle, kTurn);
    const bool isPlain = options.allowed == Interpretations::Plain;
    std::vector<Hypothesis> origins;
    if (std::abs(zero) < kAbout && (!isPlain || hypothesis.abscissaFactor == 1.0)) {
        Hypothesis fixed = hypothesis;
        fixed.unknowns[4] = plainAngle;
        fixed.isFree[kOrigin] = false;
        origins.push_back(std::move(fixed));
    }
    if (!isPlain) {
        origins.push_back(hypothesis);
        origins.back().isFree[kOrigin] = true;
    }
    std::vector<Hypothesis> all;
    for (Hypothesis &origin : origins) {
        const std::vector<double> speeds = speedsToldBy(data, columnRegressions(data, origin));
        origin.isFree[kSpeed] = !speeds.empty();
        for (const double speed : speeds.empty() ? std::vector<double>{options.given.omega2} : speeds) {
            all.push_back(origin);
            all.back().unknowns[3] = speed;
        }
    }
    return all;
}

/// Adds the interpretations of one mirror image of the shape for every size and unit of time.
void addOfImage(const Observations &data, Hypothesis hypothesis, const InterpretationOptions &options,
                std::vector<Interpretation> &interpretations)
{
    constexpr double kHardlyExplained = -1.0;
    constexpr std::size_t kValleyRows = 80;
    const std::vector<ColumnRegression> regressions = columnRegressions(data, hypothesis);
    if (regressions.empty()) {
        return;
    }
    const bool hasDerivatives = std::ranges::any_of(data.columns, [](const ObservedColumn &column) {
        return tellsShape(column) && column.channel.order != Order::Position;
    });
    const bool mayBeOtherTime = options.allowed == Interpretations::All && hasDerivatives && !data.isByCrankAngle;
    for (const double size : sizesToldBy(data, regressions, options, hypothesis)) {
        for (const double timeUnit : kTimeFactors) {
            if (timeUnit != 1.0 && !mayBeOtherTime) {
                continue;
            }
            hypothesis.timeUnit = timeUnit;
            std::optional<Interpretation> result = interpret(data, hypothesis, regressions, size, options.allowed);
            const bool isPoor = result && result->misfit > kHardlyExplained;
            if (options.allowed == Interpretations::Plain && options.isShortArc && isPoor) {
                if (const auto better = continued(thinned(data, kValleyRows), hypothesis, regressions, size)) {
                    if (const auto again = columnRegressions(data, *better); !again.empty()) {
                        result = interpret(data, *better, again, 1.0, options.allowed);
                    }
                }
            }
            if (result) {
                interpretations.push_back(*std::move(result));
            }
        }
    }
}

} // namespace

double priceOf(const Observations &data, const Hypothesis &hypothesis)
{
    std::map<std::tuple<Kind, double, bool>, int> causes; // kind, amount, of angles → number of columns
    std::array<int, 2> columnCounts{};
    double price = (hypothesis.side < 0.0 ? kPriceOfCrossed : 0.0) + priceOfAbscissa(data, hypothesis);
    int perFileTime = 0;
    bool isDepth = false; // R4x is counted from another origin in the other direction
    for (std::size_t j = 0; j < hypothesis.columns.size(); ++j) {
        const ColumnUse &use = hypothesis.columns[j];
        const bool angle = !isLength(use.channel);
        columnCounts[angle ? 1 : 0] += tellsShape(data.columns[j]) ? 1 : 0;
        if (!use.isUsed) {
            ++causes[{Kind::NotDerivative, 0.0, false}];
            continue;
        }
        if (use.unit != 1.0) {
            ++causes[{angle ? Kind::AngleUnit : Kind::LengthUnit, use.unit, angle}];
        }
        if (use.sign < 0.0) {
            ++causes[{Kind::Sign, -1.0, angle}];
            isDepth = isDepth || (use.channel == Channel{R4x, Order::Position} && use.hasOffset);
        }
        if (use.channel != data.columns[j].channel) {
            ++causes[{Kind::SwappedColumns, 0.0, false}];
        }
        perFileTime += hypothesis.timeUnit != 1.0 && use.perTime == 1.0 && use.channel.order != Order::Position ? 1 : 0;
        price += (use.isHalfTurned() ? kPriceOfHalfTurn : 0.0) + (use.hasOffset ? kPriceOfOffset : 0.0);
    }
    for (const auto &[cause, count] : causes) {
        const auto &[kind, amount, angle] = cause;
        const bool mayConcernAll = kind != Kind::NotDerivative && kind != Kind::SwappedColumns;
        const bool concernsAll = mayConcernAll && count > 1 && count >= columnCounts[angle ? 1 : 0];
        const bool isOfDepth = isDepth && kind == Kind::Sign && !angle;
        price += (isOfDepth ? kPriceOfDepth : kPriceOfCause) + kPriceOfColumn * (concernsAll ? 1 : count);
    }
    return price + (hypothesis.timeUnit != 1.0 ? kPriceOfCause + kPriceOfColumn * (1 + perFileTime) : 0.0);
}

void addInterpretations(const Observations &data, const Fit &shape, const InterpretationOptions &options,
                        std::vector<Interpretation> &interpretations)
{
    constexpr double kValleyRowsPerTurn = 6.0;
    std::vector<double> speedShifts{0.0}; // aliases
    const double rowSpeed = kTurn / data.interval();
    const bool hasDerivatives = std::ranges::any_of(data.columns, [](const ObservedColumn &column) {
        return tellsShape(column) && column.channel.order != Order::Position;
    });
    if (!data.isByCrankAngle && hasDerivatives &&
        std::abs(shape.hypothesis.unknowns[3]) * kValleyRowsPerTurn > rowSpeed) {
        for (const double turns : {-3.0, -2.0, -1.0, 1.0, 2.0, 3.0}) {
            speedShifts.push_back(turns * rowSpeed);
        }
    }
    for (const double shift : speedShifts) {
        Parameters alias = middleParameters(shape.hypothesis);
        alias.omega2 += shift;
        alias.theta20 -= shift * data.abscissa.front();
        for (const Parameters &image : mirrorImages(alias)) {
            if (options.stop.stop_requested()) {
                return;
            }
            Hypothesis hypothesis;
            for (std::size_t j = 0; j < data.columns.size(); ++j) {
                ColumnUse use{shape.hypothesis.columns[j].channel};
                if (isLength(use.channel) != isLength(data.columns[j].channel)) {
                    use.base = isLength(use.channel) ? kDegreesPerRadian : 1.0 / kDegreesPerRadian;
                }
                hypothesis.columns.push_back(use);
            }
            setMiddleParameters(image, hypothesis);
            hypothesis.abscissaStep = data.step;
            if (!data.isByCrankAngle) {
                addOfImage(data, std::move(hypothesis), options, interpretations);
                continue;
            }
            hypothesis.abscissaFactor = shape.hypothesis.abscissaFactor * (image.omega2 < 0.0 ? -1.0 : 1.0);
            hypothesis.unknowns[3] = 1.0; // rad/s, until the derivatives determine it
            for (Hypothesis &crank : crankHypotheses(data, hypothesis, options)) {
                addOfImage(data, std::move(crank), options, interpretations);
            }
        }
    }
}

} // namespace slidercrank
