// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/interpretation.h"

#include "core/import/crank_angles.h"
#include "core/mechanism/find_element.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

// Prices in units of the score: twice the negative logarithm of the prior odds against the plain interpretation.
constexpr double kPriceOfCause = 20.0;
constexpr double kPriceOfColumn = 4.0;
constexpr double kPriceOfHalfTurn = 14.0; // less than an offset, so that a half turn beats an offset of 180°
constexpr double kPriceOfDepth =
    10.0; // instead of kPriceOfCause: with another origin, R4x may also have the other direction
constexpr double kPriceOfCrossed = 6.0;   // breaks ties only
constexpr double kPriceOfOffset = 26.0;   // more than a sign, so that a sign beats an offset of twice the value
constexpr double kPriceOfParameter = 6.0; // about ln N

/// The factor that undoes the unit conversion of a heading if an angle has the heading of a length, or the reverse.
double headingConversion(const ObservedColumn &column, Channel channel)
{
    return isLength(channel) == isLength(column.channel) ? 1.0
           : isLength(channel)                           ? kDegreesPerRadian
                                                         : 1.0 / kDegreesPerRadian;
}

/// The crank angle where that of the file is zero, rad.
double crankOrigin(const Observations &data, const Hypothesis &hypothesis)
{
    return std::remainder(hypothesis.unknowns[4] - hypothesis.abscissaFactor * data.origin, kTurn);
}

/// Chooses the unit and sign with which the column fits the model best; only the sign if the unit would cancel another
/// conversion, and for R4y, whose origin may be another one.
void chooseUnit(const ObservedColumn &column, const ColumnRegression &regression, double size, ColumnUse &use)
{
    const double slope = isConstantByNature(use.channel) ? column.mean / regression.meanModel : regression.slope();
    const double wanted = slope != 0.0 ? size / slope / use.conversion : 1.0;
    if (use.channel == Channel{R4y, Order::Position} && std::abs(wanted + 1.0) > 0.1) {
        return;
    }
    const std::span<const double> units =
        isLength(use.channel) ? std::span<const double>(kLengthFactors) : kAngleFactors;
    const double factor = nearestFactor(units, wanted, column.unitOfHeading);
    use.unit = std::copysign(factor * use.conversion == 1.0 ? 1.0 : factor, wanted);
}

/// Interprets one column in the best allowed way and returns its misfit.
double interpretColumn(const Observations &data, std::size_t j, const ColumnRegression &regression, double size,
                       bool isPlain, Hypothesis &hypothesis)
{
    constexpr double kResolution = 1e-10;   // of the variance: the accuracy of a fitted shape
    constexpr double kExplained = 0.01;     // of the variance: a column with a larger misfit is not explained
    constexpr double kContradiction = 50.0; // more than two columns that fit perfectly
    const ObservedColumn &column = data.columns[j];
    ColumnUse &use = hypothesis.columns[j];
    if (!isPlain) {
        chooseUnit(column, regression, size, use);
    }
    const double factor = use.factor();
    const double aboutMean = regression.meanSquare(factor, size) + factor * factor * column.meanVariance;
    double offset = regression.offset(factor, size);
    if (isAngle(use.channel.coordinate) && use.channel.order == Order::Position) {
        const bool wholeTurns = isPlain || use.channel.coordinate == Theta2;
        const double part = wholeTurns ? kTurn : std::numbers::pi;
        use.turn = part * std::round(offset / part);
        offset -= use.turn;
    }
    const double size2 = std::pow(sizeOf(data, hypothesis, j), 2.0);
    const auto misfit = [&](double square) {
        return square > kExplained * size2 ? 0.0 : regression.n * std::log(square / size2 + kResolution);
    };
    double best = misfit(aboutMean + offset * offset);
    if (isPlain) {
        return best;
    }
    const bool isNeeded = !mayBeLeftOut(column.channel); // its origin may be another one
    if (isNeeded) {
        const double price = kPriceOfOffset + kPriceOfParameter - (use.isHalfTurned() ? kPriceOfHalfTurn : 0.0);
        if (misfit(aboutMean) + price < best) {
            use.hasOffset = true;
            use.unit *= isConstantByNature(use.channel) && use.unit < 0.0 ? -1.0 : 1.0; // a sign explains nothing more
            use.turn -= use.isHalfTurned() ? std::numbers::pi : 0.0;
            hypothesis.unknowns[Hypothesis::offsetIndex(j)] = regression.offset(use.factor(), size) - use.turn;
            best = misfit(aboutMean);
        }
    }
    if (best >= 0.0 && tellsShape(column) && use.channel == column.channel) {
        if (isNeeded) {
            return kContradiction * regression.n;
        }
        use = {column.channel};
        use.isUsed = false;
    }
    return best;
}

/// Chooses the best interpretation of each column. The lengths of the hypothesis are multiplied by `size` first.
/// Returns no fit if too few columns are left.
Fit interpret(const Observations &data, const Hypothesis &hypothesis, const std::vector<ColumnRegression> &regressions,
              double size, bool isPlain)
{
    Fit result{hypothesis};
    result.hypothesis.unknowns.head(3) *= size;
    result.score = 0.0;
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        ColumnUse &use = result.hypothesis.columns[j];
        use.conversion = headingConversion(data.columns[j], use.channel) *
                         std::pow(result.hypothesis.timeUnit, static_cast<int>(use.channel.order));
        const double columnSize = isLength(use.channel) ? size : 1.0;
        if (regressions[j].n > 0.0) {
            result.score += interpretColumn(data, j, regressions[j], columnSize, isPlain, result.hypothesis);
        }
    }
    result.score += priceOf(data, result.hypothesis);
    return keepsEnough(result.hypothesis) ? result : Fit();
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
            if (!options.isPlain || regressions[j].slope() > 0.0) {
                addDistinct(std::abs(regressions[j].slope()) * headingConversion(data.columns[j], use.channel), sizes);
            }
        }
    }
    hypothesis.isFree[indexOf(Parameter::A)] = hasLength;
    if (!hasLength) {
        sizes.push_back(options.given.a / std::abs(hypothesis.unknowns[0]));
    }
    return options.hasSize ? std::vector{1.0} : sizes;
}

/// The crank speeds that follow from the time derivatives in a file by crank angle, if ω2 = 1 in the hypothesis.
std::vector<double> speedsToldBy(const Observations &data, const std::vector<ColumnRegression> &regressions)
{
    std::vector<double> speeds;
    const std::size_t slider = columnIndex(data.columns, {R4x, Order::Position});
    const bool hasSize = slider < regressions.size() && tellsShape(data.columns[slider]);
    const double size = hasSize ? std::abs(regressions[slider].slope()) : 1.0; // of the lengths
    for (std::size_t j = 0; j < regressions.size(); ++j) {
        const Channel channel = data.columns[j].channel;
        if (channel == Channel{Theta2, Order::Velocity}) {
            addDistinct(data.columns[j].mean, speeds);
        }
        if (isShapeDerivative(data.columns[j])) {
            const double power = std::abs(regressions[j].slope()) / (isLength(channel) ? size : 1.0);
            const double speed = channel.order == Order::Velocity ? power : std::sqrt(power);
            addDistinct(speed, speeds);
            addDistinct(-speed, speeds);
        }
    }
    return speeds;
}

/// The hypotheses on the crank angle of a file by crank angle: its origin as in the file or free, with each speed that
/// follows from the derivatives.
std::vector<Hypothesis> crankHypotheses(const Observations &data, const Hypothesis &hypothesis,
                                        const InterpretationOptions &options)
{
    constexpr std::size_t kOrigin = indexOf(Parameter::Theta20);
    constexpr std::size_t kSpeed = indexOf(Parameter::Omega2);
    std::vector<Hypothesis> all;
    for (const bool isFixed : {true, false}) {
        if (options.isPlain && !(isFixed && hypothesis.abscissaFactor == 1.0)) {
            continue;
        }
        Hypothesis crank = hypothesis;
        crank.isFree[kOrigin] = !isFixed;
        crank.unknowns[4] = isFixed ? hypothesis.abscissaFactor * data.origin : hypothesis.unknowns[4];
        const std::vector<double> speeds = speedsToldBy(data, columnRegressions(data, crank));
        crank.isFree[kSpeed] = !speeds.empty();
        for (const double speed : speeds.empty() ? std::vector<double>{options.given.omega2} : speeds) {
            crank.unknowns[3] = speed;
            all.push_back(crank);
        }
    }
    return all;
}

/// Adds the interpretations of one mirror image of the shape for every size and unit of time.
void addOfImage(const Observations &data, Hypothesis hypothesis, const InterpretationOptions &options,
                std::vector<Fit> &interpretations)
{
    const std::vector<ColumnRegression> regressions = columnRegressions(data, hypothesis);
    if (regressions.empty()) {
        return;
    }
    const bool mayBeOtherTime =
        !options.isPlain && std::ranges::any_of(data.columns, isShapeDerivative) && !data.isByCrankAngle;
    const double wrongTime = data.unitOfHeading == 1.0 ? kTimeFactors[1] : 1.0 / data.unitOfHeading;
    const std::array timeUnits{1.0, nearestFactor(kTimeFactors, wrongTime, data.unitOfHeading)};
    for (const double size : sizesToldBy(data, regressions, options, hypothesis)) {
        for (const double timeUnit : std::span(timeUnits).first(mayBeOtherTime ? timeUnits.size() : 1)) {
            hypothesis.timeUnit = timeUnit;
            Fit result = interpret(data, hypothesis, regressions, size, options.isPlain);
            if (result.exists()) {
                interpretations.push_back(std::move(result));
            }
        }
    }
}

} // namespace

std::vector<Convention> conventionsOf(const Observations &data, const Hypothesis &hypothesis)
{
    std::vector<Convention> conventions;
    const auto add = [&](Kind kind, double amount, Channel channel) {
        const auto isSame = [&](const Convention &other) {
            return other.kind == kind && other.amount == amount &&
                   (kind != Kind::Sign || isLength(other.channels.front()) == isLength(channel));
        };
        if (Convention *const known = findElement(conventions, isSame)) {
            known->channels.push_back(channel);
        } else {
            conventions.push_back({kind, {channel}, amount});
        }
    };
    for (std::size_t j = 0; j < data.columns.size(); ++j) { // first, because the others name the columns as exchanged
        const Channel heading = data.columns[j].channel;
        if (indexOf(heading) < indexOf(hypothesis.columns[j].channel)) {
            conventions.push_back({Kind::SwappedColumns, {heading, hypothesis.columns[j].channel}, 1.0});
        }
    }
    if (hypothesis.timeUnit != 1.0) {
        conventions.push_back({Kind::TimeUnit, {}, hypothesis.timeUnit});
    }
    const auto addUnitAndSign = [&](const ColumnUse &use) {
        if (std::abs(use.unit) != 1.0) {
            add(isLength(use.channel) ? Kind::LengthUnit : Kind::AngleUnit, std::abs(use.unit), use.channel);
        }
        if (use.unit < 0.0) {
            add(Kind::Sign, -1.0, use.channel);
        }
    };
    if (data.isByCrankAngle) {
        addUnitAndSign({kCrankAngle, hypothesis.abscissaFactor});
        if (hypothesis.isFree[indexOf(Parameter::Theta20)]) {
            add(Kind::ZeroPoint, crankOrigin(data, hypothesis) * kDegreesPerRadian, kCrankAngle);
        }
    }
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        const ColumnUse &use = hypothesis.columns[j];
        if (!use.isUsed) {
            add(Kind::NotDerivative, 1.0, use.channel);
            continue;
        }
        addUnitAndSign(use);
        if (use.channel == Channel{Theta3, Order::Position} && (use.turn != 0.0 || data.columns[j].hadJumps)) {
            add(use.isHalfTurned() ? Kind::HalfTurn : Kind::WholeTurns, -use.turn * kDegreesPerRadian, use.channel);
        }
        if (use.hasOffset) {
            add(Kind::ZeroPoint, -toFileUnit(use.channel, hypothesis.offset(j)), use.channel);
        }
    }
    return conventions;
}

bool mayBeLeftOut(Channel channel)
{
    return channel.order != Order::Position ||
           (channel.coordinate != Theta2 && channel.coordinate != R4y && !isPlotted(channel));
}

bool keepsEnough(const Hypothesis &hypothesis)
{
    const auto used = std::ranges::count(hypothesis.columns, true, &ColumnUse::isUsed);
    return 2 * used >= std::ssize(hypothesis.columns) ||
           std::ranges::any_of(hypothesis.columns, [](const ColumnUse &use) {
               return use.isUsed && isPlotted(use.channel) && use.channel.order == Order::Position;
           });
}

double priceOf(const Observations &data, const Hypothesis &hypothesis)
{
    const std::vector<Convention> conventions = conventionsOf(data, hypothesis);
    const bool hasOtherOrigin = std::ranges::any_of(conventions, [](const Convention &convention) {
        return convention.kind == Kind::ZeroPoint && concerns(convention, {R4x, Order::Position});
    });
    double price = hypothesis.side < 0.0 ? kPriceOfCrossed : 0.0;
    for (const Convention &convention : conventions) {
        const Kind kind = convention.kind;
        const bool isUnit = kind == Kind::AngleUnit || kind == Kind::LengthUnit;
        if (kind == Kind::HalfTurn) {
            price += kPriceOfHalfTurn;
        } else if (kind == Kind::ZeroPoint) {
            price += kPriceOfOffset;
        } else if (kind != Kind::WholeTurns) {
            auto columns = std::max(std::ranges::ssize(convention.channels), std::ptrdiff_t{1});
            const auto isAlike = [&](const ObservedColumn &column) {
                return tellsShape(column) && isLength(column.channel) == isLength(convention.channels.front());
            };
            if ((isUnit || kind == Kind::Sign) && columns >= std::ranges::count_if(data.columns, isAlike)) {
                columns = 1; // one cause for all of them
            }
            const bool isDepth = kind == Kind::Sign && hasOtherOrigin && concerns(convention, {R4x, Order::Position});
            price += (isDepth ? kPriceOfDepth : kPriceOfCause) + kPriceOfColumn * static_cast<double>(columns);
        }
    }
    return price;
}

void addInterpretations(const Observations &data, const Fit &shape, const InterpretationOptions &options,
                        std::vector<Fit> &interpretations)
{
    constexpr double kFewRowsPerTurn = 6.0;
    const double rowSpeed = kTurn / data.interval();
    const bool mayBeAlias = !data.isByCrankAngle && std::ranges::any_of(data.columns, isShapeDerivative) &&
                            std::abs(shape.hypothesis.unknowns[3]) * kFewRowsPerTurn > rowSpeed;
    constexpr std::array kTurns{0.0, -1.0, 1.0};
    for (const double turns : std::span(kTurns).first(mayBeAlias ? kTurns.size() : 1)) {
        Parameters alias = middleParameters(shape.hypothesis);
        alias.omega2 += turns * rowSpeed;
        alias.theta20 -= turns * rowSpeed * data.abscissa.front();
        for (const Parameters &image : mirrorImages(alias)) {
            Hypothesis hypothesis;
            for (std::size_t j = 0; j < data.columns.size(); ++j) {
                hypothesis.columns.push_back({shape.hypothesis.columns[j].channel});
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
