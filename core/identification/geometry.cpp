// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/geometry.h"

#include "core/identification/column_scale.h"
#include "core/identification/residual_test.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <span>

namespace slidercrank
{

namespace
{

/// The origins that a search allows for columns of positions: the usual ones, which are 0 for lengths and any multiple
/// of half a turn for θ3, or any. Derivatives have no origin.
enum class Origins { Usual, Any };

/// The values that the origin of one column may have.
enum class ColumnOrigin { Zero, HalfTurns, Any };

ColumnOrigin allowedOrigin(Channel channel, Origins origins)
{
    if (channel.order != Order::Position) {
        return ColumnOrigin::Zero;
    }
    if (origins == Origins::Any) {
        return ColumnOrigin::Any;
    }
    return isAngle(channel.coordinate) ? ColumnOrigin::HalfTurns : ColumnOrigin::Zero;
}

/// The factor and the origin with which a motion fits a column best, and the mean square of the residuals then.
struct Regression {
    ColumnReading reading{0.0, 0.0};
    double meanSquare = kInfinity;
};

/// The sums from which a Regression is computed: over the rows in which a column has a value y, with the motion f
/// there. `n` is their number, `fy` the sum of f · y, and so on.
struct Moments {
    double n = 0.0, f = 0.0, y = 0.0, ff = 0.0, fy = 0.0, yy = 0.0;
};

Moments computeMoments(const Values &motion, const Values &values)
{
    Moments m;
    for (Index i = 0; i < values.size(); ++i) {
        if (const double y = values[i]; std::isfinite(y)) {
            const double f = motion[i];
            m = {m.n + 1.0, m.f + f, m.y + y, m.ff + f * f, m.fy + f * y, m.yy + y * y};
        }
    }
    return m;
}

/// Fits the origin of a column whose factor is known, by least squares.
Regression fitOrigin(const Moments &m, double factor, ColumnOrigin columnOrigin)
{
    double origin = columnOrigin == ColumnOrigin::Zero ? 0.0 : (m.y - factor * m.f) / m.n;
    if (columnOrigin == ColumnOrigin::HalfTurns) {
        origin = nearestHalfTurns(origin, factor);
    }
    const double sumOfSquares = m.yy + factor * factor * m.ff + m.n * origin * origin -
                                2.0 * (factor * m.fy + origin * m.y - factor * origin * m.f);
    return {{factor, origin}, std::max(sumOfSquares, 0.0) / m.n};
}

/// Fits the factor and the origin of a column by least squares.
Regression fitFactorAndOrigin(const Moments &m, ColumnOrigin columnOrigin)
{
    // If the origin may be any number, the factor follows from the deviations of motion and values from their means.
    const double weightOfMeans = columnOrigin == ColumnOrigin::Any ? 1.0 / m.n : 0.0;
    const double productsWithMotion = m.fy - weightOfMeans * m.f * m.y;
    const double squaresOfMotion = m.ff - weightOfMeans * m.f * m.f;
    return fitOrigin(m, productsWithMotion / squaresOfMotion, columnOrigin);
}

/// Fits the reading of θ3. Its factor is not free, because it would be the same unknown as b where sin θ3 ≈ θ3: only
/// both signs and the units of angles are tried.
Regression fitCouplerReading(const Moments &moments, ColumnOrigin origin)
{
    Regression best;
    for (const double unit : kAngleFactors) {
        for (const double factor : {unit, -unit}) {
            const Regression regression = fitOrigin(moments, factor, origin);
            best = regression.meanSquare < best.meanSquare ? regression : best;
        }
    }
    return best;
}

/// Whether the values of a column depend on a speed of the crank that is not known yet. Those of a derivative over the
/// angle in the file do; its motion is computed for ω2 = 1 rad/s.
bool dependsOnUnknownSpeed(const ObservedColumn &column, const Model &model)
{
    return column.isDerivative() && model.followsAngle;
}

/// Fits the reading of a column to the motion of a mechanism with a = 1 mm. For lengths, |factor| is the length of the
/// crank (mm); for angles, it is a unit conversion. For columns that depend on an unknown speed, the factor is
/// multiplied by this speed to the power of the order of the derivative. `moments`: sums over the values of the column
/// and the motion.
Regression fitColumn(const ObservedColumn &column, const Moments &moments, const Model &model, ColumnOrigin origin)
{
    return column.containsAngles() && !dependsOnUnknownSpeed(column, model) ? fitCouplerReading(moments, origin)
                                                                            : fitFactorAndOrigin(moments, origin);
}

/// The true size and speed of a mechanism that was fitted to columns with a = 1 mm and, over the angle, ω2 = 1 rad/s.
struct SizeAndSpeed {
    double crankLength = 1.0; ///< mm
    double speed = 1.0;       ///< ω2, rad/s, if the model follows the angle in the file
};

/// The size and the speed that the factors of the columns show. If no column shows the size, it is the given one; if
/// none shows the speed, it is the given one or, if that is 0, 1 rad/s. `regressions`: the result of fitColumn() for
/// each of `columns`.
SizeAndSpeed sizeAndSpeedOfColumns(const Observations &observations, const Indices &columns,
                                   const std::vector<Regression> &regressions, const Model &model,
                                   const Parameters &given)
{
    SizeAndSpeed result{.crankLength = given.a};
    if (given.omega2 != 0.0) { // at a speed of 0, all derivatives are 0 and show no length
        result.speed = given.omega2;
    }
    // θ3 is the first of the columns (shapeColumns()): its derivatives show the speed, with which those of R4_x show
    // the length.
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const ObservedColumn &column = observations.columns[columns[i]];
        const auto order = static_cast<double>(column.channel.order);
        const double factor = std::abs(regressions[i].reading.factor);
        const bool containsSpeed = dependsOnUnknownSpeed(column, model);
        if (!column.containsAngles()) {
            result.crankLength = containsSpeed ? factor / std::pow(std::abs(result.speed), order) : factor;
        } else if (containsSpeed) {
            result.speed = std::pow(factor, 1.0 / order);
        }
    }
    return result;
}

/// The reading of a column after the mechanism has got its true size and speed: of the factor of a length, or of a
/// derivative over the angle, only the sign remains, because size and speed replace the magnitude. θ3 keeps its factor,
/// which is a unit conversion. `fitted`: the reading before, from fitColumn(). `speed`: ω2, rad/s.
ColumnReading readingAfterScaling(const ObservedColumn &column, const ColumnReading &fitted, const Model &model,
                                  double speed)
{
    if (dependsOnUnknownSpeed(column, model)) {
        // At a negative speed, a velocity with a negative factor has the usual sign.
        const double factorOfSpeed = std::pow(speed, static_cast<double>(column.channel.order));
        return {std::copysign(1.0, fitted.factor * factorOfSpeed), fitted.origin};
    }
    return column.containsAngles() ? fitted : ColumnReading{std::copysign(1.0, fitted.factor), fitted.origin};
}

/// A model from which a fit may start, and the result of misfitOfRegressions() for it.
struct Candidate {
    double misfit = kInfinity;
    Model model;
};

/// The misfit of some columns, as if each had one value. (The columns have nearly the same number of values, so that
/// this orders the candidates as the misfit would.)
double misfitOfRegressions(const Observations &observations, const Indices &columns,
                           const std::vector<Regression> &regressions)
{
    double misfit = 0.0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const ObservedColumn &column = observations.columns[columns[i]];
        misfit += std::log(regressions[i].meanSquare + column.variance);
    }
    return misfit;
}

/// Fits the reading of each of some columns. `moments`: those of each column and its motion.
std::vector<Regression> fitColumns(const Observations &observations, const Indices &columns,
                                   const std::vector<Moments> &moments, const Model &model, Origins origins)
{
    std::vector<Regression> regressions;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const ObservedColumn &column = observations.columns[columns[i]];
        regressions.push_back(fitColumn(column, moments[i], model, allowedOrigin(column.channel, origins)));
    }
    return regressions;
}

/// Scales a mechanism with a = 1 mm to the size that `regressions`, the result of fitColumns(), show, and sets the
/// readings of the columns. A model that follows the angle in the file also gets the speed that derivatives show. What
/// the columns do not show is that of `given`.
Candidate scaleToColumns(Model model, const Observations &observations, const Indices &columns,
                         const std::vector<Regression> &regressions, const Parameters &given)
{
    const SizeAndSpeed shown = sizeAndSpeedOfColumns(observations, columns, regressions, model, given);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Index k = columns[i];
        model.readings[k] = readingAfterScaling(observations.columns[k], regressions[i].reading, model, shown.speed);
    }
    if (model.followsAngle) {
        model.mechanism.omega2 = shown.speed;
    }
    for (const Parameter length : kLengths) {
        valueOf(model.mechanism, length) *= shown.crankLength;
    }
    return {.misfit = misfitOfRegressions(observations, columns, regressions), .model = std::move(model)};
}

/// The best candidates of a coarse grid of mechanisms: those for columns with their usual origins, and those for
/// columns with any origins.
struct GridResult {
    std::vector<Candidate> usualOrigins, anyOrigins;
};

void replaceIfBetter(Candidate &best, Candidate candidate)
{
    if (candidate.misfit < best.misfit) {
        best = std::move(candidate);
    }
}

/// Removes all candidates but those with the lowest misfits, and sorts these.
void keepBest(std::vector<Candidate> &candidates)
{
    constexpr std::size_t kMaxCandidates = 6; // the right one is not always the best on a coarse grid; each costs a fit
    std::erase_if(candidates, [](const Candidate &candidate) { return !std::isfinite(candidate.misfit); });
    std::ranges::sort(candidates, {}, &Candidate::misfit);
    candidates.resize(std::min(kMaxCandidates, candidates.size()));
}

/// Tries a mechanism with a = 1 mm with several values of θ20, and appends the best candidate of these to each list of
/// `result`.
void addBestCandidates(GridResult &result, Model model, const Observations &observations, const Indices &columns,
                       const Parameters &given)
{
    constexpr int kAngleCount = 16; // every 22.5°
    Candidate usual, any;
    for (int i = 0; i < kAngleCount; ++i) {
        model.mechanism.theta20 = kTurn * i / kAngleCount;
        const Eigen::ArrayXXd motion = computeMotion(model, observations, columns);
        std::vector<Moments> moments;
        for (Index k = 0; k < motion.cols(); ++k) {
            moments.push_back(computeMoments(motion.col(k), observations.columns[columns[k]].values));
        }
        const auto candidateWith = [&](Origins origins) {
            return scaleToColumns(model, observations, columns,
                                  fitColumns(observations, columns, moments, model, origins), given);
        };
        replaceIfBetter(usual, candidateWith(Origins::Usual));
        replaceIfBetter(any, candidateWith(Origins::Any));
    }
    result.usualOrigins.push_back(std::move(usual));
    result.anyOrigins.push_back(std::move(any));
}

/// Tries mechanisms of all proportions, each with the best angle of the crank. Couplers shorter than a + |c| belong to
/// cranks that oscillate. Neighbouring proportions are so near that a fit which starts at one reaches mechanisms up to
/// the next; it also reaches those beyond the longest coupler and offset. `start`: one of startModels().
GridResult searchGrid(const Observations &observations, const Indices &columns, const Model &start,
                      const Parameters &given)
{
    constexpr std::array kCouplerRatios{0.6, 0.85, 1.08, 1.25, 1.5, 1.9, 2.5, 3.5, 5.5, 10.0};        // b / (a + |c|)
    constexpr std::array kOffsetRatios{0.0, -0.3, 0.3, -0.6, 0.6, -0.9, 0.9, -2.0, 2.0, -12.0, 12.0}; // c / a
    GridResult result;
    Model model = start;
    // Over the angle in the file, derivatives are compared with those by the angle, which are those of ω2 = 1.
    const double speed = start.followsAngle ? 1.0 : start.mechanism.omega2;
    for (const double offset : kOffsetRatios) {
        for (const double coupler : kCouplerRatios) {
            model.mechanism = {.a = 1.0, .b = coupler * (1.0 + std::abs(offset)), .c = offset, .omega2 = speed};
            addBestCandidates(result, model, observations, columns, given);
        }
    }
    keepBest(result.usualOrigins);
    keepBest(result.anyOrigins);
    return result;
}

/// The unknowns that the columns determine.
Unknowns geometryUnknowns(const Observations &observations, const Indices &columns, Origins origins)
{
    Unknowns unknowns{Parameter::B, Parameter::C, Parameter::Theta20};
    const auto isPosition = [&](Index k) { return !observations.columns[k].isDerivative(); };
    const auto isLength = [&](Index k) { return !observations.columns[k].containsAngles(); };
    if (std::ranges::any_of(columns, isLength)) {
        unknowns.push_back(Parameter::A);
    }
    const auto showsSpeed = [&](Index k) { return !isPosition(k) && !isLength(k); };
    // Over the angle, derivatives of lengths determine only the products a · ω2 and a · ω2², and not ω2.
    if (!observations.hasAngle() || std::ranges::any_of(columns, showsSpeed)) {
        unknowns.push_back(Parameter::Omega2);
    }
    for (const Index k : columns) {
        if (isPosition(k) && origins == Origins::Any) {
            unknowns.push_back(originOf(k));
        }
    }
    return unknowns;
}

/// Fits candidates one after the other. Stops after a fit whose residuals are rounding, because none can be better.
std::vector<Fit> fitCandidates(const Observations &observations, const Indices &columns,
                               const std::vector<Candidate> &candidates, const Unknowns &unknowns)
{
    constexpr int kIterationLimit = 20; // enough to see which candidates are worth a complete fit
    std::vector<Fit> fits;
    for (const Candidate &candidate : candidates) {
        fits.push_back(fitModel(observations, candidate.model, columns, unknowns, kIterationLimit));
        if (isExact(observations, fits.back())) {
            break;
        }
    }
    return fits;
}

/// Repeats the best two of some fits with all rows of `observations`, and returns the better one. Not finite if there
/// are no fits, or if none is finite.
Fit repeatBestFits(const Observations &observations, std::vector<Fit> fits)
{
    constexpr std::size_t kRepeatedFits = 2; // the best fit of some rows may be the second one of all
    Fit best;
    std::ranges::sort(fits, {}, &Fit::misfit);
    fits.resize(std::min(kRepeatedFits, fits.size()));
    for (const Fit &start : fits) {
        Fit fit = fitModel(observations, start.model, start.columns, start.unknowns);
        if (fit.misfit < best.misfit) {
            best = std::move(fit);
        }
    }
    return best;
}

/// The models from which the search starts: one for each unit in which the angle of the crank may be in the file, or,
/// if the file does not contain this angle, one for each candidate of the speed.
std::vector<Model> startModels(const Observations &observations, const std::vector<double> &speeds,
                               const Parameters &given)
{
    Model model{.mechanism = given, .followsAngle = observations.hasAngle()};
    model.readings.resize(observations.columns.size());
    std::vector<Model> models;
    if (model.followsAngle) {
        for (const double unit : kAngleFactors) {
            model.angleFactor = unit;
            models.push_back(model);
        }
    } else {
        for (const double speed : speeds) {
            model.mechanism.omega2 = speed;
            models.push_back(model);
        }
    }
    return models;
}

/// The columns of a coordinate in the file that change: position, velocity, acceleration, as far as they exist.
Indices changingColumns(const Observations &observations, Coordinate coordinate)
{
    Indices columns;
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        const auto column =
            std::ranges::find(observations.columns, Channel{coordinate, order}, &ObservedColumn::channel);
        if (column != observations.columns.end() && !column->isConstant()) {
            columns.push_back(column - observations.columns.begin());
        }
    }
    return columns;
}

/// Indices in the result of changingColumns().
constexpr std::size_t kLowestOrder = 0;
constexpr std::size_t kSecondLowestOrder = 1;

/// For each of some coordinates, the column at index n of changingColumns(), as far as it exists.
Indices columnsOfNthOrder(const Observations &observations, std::span<const Coordinate> coordinates, std::size_t n)
{
    Indices columns;
    for (const Coordinate coordinate : coordinates) {
        const Indices changing = changingColumns(observations, coordinate);
        if (changing.size() > n) {
            columns.push_back(changing[n]);
        }
    }
    return columns;
}

/// The model of a geometry, in which each of `columns` that it does not use has usualFactor() (a sign and a unit).
Model withUsualFactors(const Observations &observations, const Fit &geometry, const Indices &columns)
{
    Model model = geometry.model;
    for (const Index k : columns) {
        if (!geometry.usesColumn(k)) {
            model.readings[k].factor = usualFactor(observations, geometry, k);
        }
    }
    return model;
}

} // namespace

Indices shapeColumns(const Observations &observations)
{
    Indices columns = columnsOfNthOrder(observations, std::array{Theta3, R4x}, kLowestOrder);
    if (columns.empty()) {
        columns = columnsOfNthOrder(observations, std::array{R3x, R3y, R2x, R2y}, kLowestOrder);
    }
    const auto isDerivative = [&](Index k) { return observations.columns[k].isDerivative(); };
    if (observations.hasAngle() && !std::ranges::all_of(columns, isDerivative)) {
        std::erase_if(columns, isDerivative);
    }
    return columns;
}

Indices higherShapeColumns(const Observations &observations)
{
    return columnsOfNthOrder(observations, std::array{Theta3, R4x}, kSecondLowestOrder);
}

bool areLengthsDetermined(const Observations &observations, const Indices &columns)
{
    std::set<Order> ordersOfLengths;
    bool hasRateOfAngle = false;
    for (const Index k : columns) {
        const ObservedColumn &column = observations.columns[k];
        if (!column.containsAngles()) {
            ordersOfLengths.insert(column.channel.order);
        }
        hasRateOfAngle = hasRateOfAngle || (column.containsAngles() && column.isDerivative());
    }
    // Over the angle of the crank, velocities show only the product of lengths and ω2, accelerations that of lengths
    // and ω2².
    const bool hasSpeed = observations.hasTime() || hasRateOfAngle;
    return ordersOfLengths.contains(Order::Position) || ordersOfLengths.size() > 1 ||
           (hasSpeed && !ordersOfLengths.empty());
}

Fit findGeometry(const Observations &observations, const Indices &columns, const std::vector<double> &speeds,
                 const Parameters &given)
{
    constexpr Index kGridRows = 40;       // for each of more than a thousand mechanisms, which are not exact anyway
    constexpr Index kCandidateRows = 120; // some dozens of candidates are fitted to them
    const Observations gridRows = selectRows(observations, kGridRows);
    const Observations candidateRows = selectRows(observations, kCandidateRows);
    const Unknowns unknowns = geometryUnknowns(observations, columns, Origins::Usual);
    std::vector<Fit> fits;
    std::vector<Candidate> candidatesWithAnyOrigins;
    for (const Model &start : startModels(observations, speeds, given)) {
        const GridResult grid = searchGrid(gridRows, columns, start, given);
        std::ranges::copy(grid.anyOrigins, std::back_inserter(candidatesWithAnyOrigins));
        std::ranges::move(fitCandidates(candidateRows, columns, grid.usualOrigins, unknowns), std::back_inserter(fits));
        if (!fits.empty() && isExact(candidateRows, fits.back())) {
            break; // no other start can be better
        }
    }
    Fit best = repeatBestFits(observations, std::move(fits));
    if (isExact(observations, best)) {
        return best;
    }
    const Unknowns unknownsWithOrigins = geometryUnknowns(observations, columns, Origins::Any);
    Fit bestWithAnyOrigins = repeatBestFits(
        observations, fitCandidates(candidateRows, columns, candidatesWithAnyOrigins, unknownsWithOrigins));
    return bestWithAnyOrigins.misfit < best.misfit ? bestWithAnyOrigins : best;
}

Fit fitWithFreeOrigins(const Observations &observations, const Fit &geometry, const Indices &columns)
{
    if (!geometry.isFinite()) {
        return geometry;
    }
    Unknowns origins;
    for (const Index k : columns) {
        if (!observations.columns[k].isDerivative()) {
            origins.push_back(originOf(k));
        }
    }
    return fitModel(observations, withUsualFactors(observations, geometry, columns), columns, origins);
}

} // namespace slidercrank
