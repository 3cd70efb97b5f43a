// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/geometry.h"

#include "core/identification/column_scale.h"
#include "core/identification/rounding_test.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace slidercrank
{

namespace
{

/// The origins that a search allows: the usual ones (0, half turns of θ3), or any for each column of positions.
enum class Origins { Usual, Any };
enum class ColumnOrigin { None, HalfTurns, Any };

ColumnOrigin originOf(Channel channel, Origins origins)
{
    if (channel.order != Order::Position) {
        return ColumnOrigin::None;
    }
    if (origins == Origins::Any) {
        return ColumnOrigin::Any;
    }
    return isAngle(channel.coordinate) ? ColumnOrigin::HalfTurns : ColumnOrigin::None;
}

/// The factor and the origin with which a motion fits a column best, and what remains.
struct Regression {
    ColumnReading reading{0.0, 0.0};
    double meanSquare = kInfinity;
};

/// Sums over the rows in which a column has a value y, with the motion f.
struct Moments {
    double n = 0.0, f = 0.0, y = 0.0, ff = 0.0, fy = 0.0, yy = 0.0;
};

Moments momentsOf(const Values &motion, const Values &values)
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

/// `fixedFactor`: nullopt if the factor may be any number.
Regression regressionOf(const Moments &m, std::optional<double> fixedFactor, ColumnOrigin columnOrigin)
{
    const double mean = columnOrigin == ColumnOrigin::Any ? 1.0 / m.n : 0.0;
    const double factor = fixedFactor.value_or((m.fy - mean * m.f * m.y) / (m.ff - mean * m.f * m.f));
    double origin = columnOrigin == ColumnOrigin::None ? 0.0 : (m.y - factor * m.f) / m.n;
    if (columnOrigin == ColumnOrigin::HalfTurns) {
        origin = std::numbers::pi * factor * std::rint(origin / (std::numbers::pi * factor));
    }
    const double squares = m.yy + factor * factor * m.ff + m.n * origin * origin -
                           2.0 * (factor * m.fy + origin * m.y - factor * origin * m.f);
    return {{factor, origin}, std::max(squares, 0.0) / m.n};
}

/// θ3 has no free factor: where sin θ3 ≈ θ3, it would be the same unknown as b.
Regression couplerRegression(const Moments &moments, ColumnOrigin origin)
{
    Regression best;
    for (const double unit : kAngleUnits) {
        for (const double factor : {unit, -unit}) {
            const Regression regression = regressionOf(moments, factor, origin);
            best = regression.meanSquare < best.meanSquare ? regression : best;
        }
    }
    return best;
}

struct Candidate {
    double misfit = kInfinity;
    Model model;
};

/// Fits the columns to the motion of a model with a = 1 by regressions, and returns the model with the readings, the
/// lengths and, in a table over the crank angle, the speed that follow from them. `moments`: of the columns and the
/// motion.
Candidate scaledToColumns(Model model, const Observations &observations, const Indices &columns,
                          const std::vector<Moments> &moments, const Parameters &given, Origins origins)
{
    constexpr double kFloor = 1e-8; // of the squared range: smaller residuals on a coarse grid are accidents
    Candidate candidate{.misfit = 0.0, .model = std::move(model)};
    Parameters &mechanism = candidate.model.mechanism;
    double crankLength = given.a; // mm
    std::optional<double> speed;  // |ω2| in a table over the crank angle, where the motion is computed for ω2 = 1
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const ObservedColumn &column = observations.columns[columns[k]];
        const double order = static_cast<double>(column.channel.order);
        const bool showsSpeed = order > 0.0 && candidate.model.followsAngle;
        const ColumnOrigin origin = originOf(column.channel, origins);
        Regression best;
        if (column.containsAngles() && !showsSpeed) {
            best = couplerRegression(moments[k], origin);
        } else {
            // Apart from its sign, the factor is the length of the crank, a power of the speed, or their product.
            best = regressionOf(moments[k], {}, origin);
            const double size = std::abs(best.reading.factor);
            if (column.containsAngles()) {
                speed = std::pow(size, 1.0 / order);
            } else { // columns of θ3 come before those of R4_x, so that the speed is known if they show it
                crankLength = showsSpeed ? size / std::pow(speed.value_or(given.omega2), order) : size;
            }
            best.reading.factor = std::copysign(1.0, best.reading.factor);
        }
        candidate.model.readings[columns[k]] = best.reading;
        candidate.misfit += std::log(best.meanSquare + column.variance + kFloor * column.range * column.range);
    }
    mechanism.omega2 = candidate.model.followsAngle ? speed.value_or(given.omega2) : mechanism.omega2;
    mechanism.a *= crankLength;
    mechanism.b *= crankLength;
    mechanism.c *= crankLength;
    return candidate;
}

/// The best candidates of a grid, by the origins that they have.
struct GridResult {
    std::vector<Candidate> usualOrigins, anyOrigins;
};

void replaceIfBetter(Candidate &best, Candidate candidate)
{
    if (candidate.misfit < best.misfit) {
        best = std::move(candidate);
    }
}

void keepBest(std::vector<Candidate> &candidates)
{
    constexpr std::size_t kCandidates = 6; // each costs a fit
    std::erase_if(candidates, [](const Candidate &candidate) { return !std::isfinite(candidate.misfit); });
    std::ranges::sort(candidates, {}, &Candidate::misfit);
    candidates.resize(std::min(kCandidates, candidates.size()));
}

/// Tries mechanisms of all proportions with all angles of the crank. The couplers shorter than a + |c| belong to cranks
/// that oscillate.
GridResult searchGrid(const Observations &observations, const Indices &columns, const Model &start,
                      const Parameters &given)
{
    constexpr std::array kCouplers{0.6, 0.85, 1.08, 1.25, 1.5, 1.9, 2.5, 3.5, 5.5, 10.0};        // b / (a + |c|)
    constexpr std::array kOffsets{0.0, -0.3, 0.3, -0.6, 0.6, -0.9, 0.9, -2.0, 2.0, -12.0, 12.0}; // c / a
    constexpr int kAngles = 16; // of the crank, every 22.5°
    GridResult result;
    Model model = start;
    // In a table over the crank angle, derivatives are compared with those by the angle, which are those of ω2 = 1.
    const double speed = start.followsAngle ? 1.0 : start.mechanism.omega2;
    for (const double offset : kOffsets) {
        for (const double coupler : kCouplers) {
            Candidate usual, any;
            for (int i = 0; i < kAngles; ++i) {
                model.mechanism = {.a = 1.0,
                                   .b = coupler * (1.0 + std::abs(offset)),
                                   .c = offset,
                                   .omega2 = speed,
                                   .theta20 = kTurn * i / kAngles};
                const Eigen::ArrayXXd motion = motionIn(model, observations, columns);
                std::vector<Moments> moments;
                for (Index k = 0; k < motion.cols(); ++k) {
                    moments.push_back(momentsOf(motion.col(k), observations.columns[columns[k]].values));
                }
                replaceIfBetter(usual, scaledToColumns(model, observations, columns, moments, given, Origins::Usual));
                replaceIfBetter(any, scaledToColumns(model, observations, columns, moments, given, Origins::Any));
            }
            result.usualOrigins.push_back(std::move(usual));
            result.anyOrigins.push_back(std::move(any));
        }
    }
    keepBest(result.usualOrigins);
    keepBest(result.anyOrigins);
    return result;
}

/// All that the columns determine.
Unknowns geometryUnknowns(const Observations &observations, const Indices &columns, bool followsAngle, Origins origins)
{
    Unknowns unknowns{{Unknown::Kind::B}, {Unknown::Kind::C}, {Unknown::Kind::CrankAngle}};
    const auto isPosition = [&](Index k) { return !observations.columns[k].isDerivative(); };
    const auto isLength = [&](Index k) { return !observations.columns[k].containsAngles(); };
    if (std::ranges::any_of(columns, isLength)) {
        unknowns.push_back({Unknown::Kind::A});
    }
    const auto showsSpeed = [&](Index k) { return !isPosition(k) && !isLength(k); };
    // Derivatives of lengths over the angle show only the product of a and ω2.
    if (!followsAngle || std::ranges::any_of(columns, showsSpeed)) {
        unknowns.push_back({Unknown::Kind::Omega2});
    }
    for (const Index k : columns) {
        if (isPosition(k) && origins == Origins::Any) {
            unknowns.push_back({Unknown::Kind::Origin, k});
        }
    }
    return unknowns;
}

/// Fits candidates until rounding explains the residuals of one: then nothing can be better. Appends the fits to `fits`
/// and returns whether that is so.
bool fitCandidates(const Observations &observations, const Indices &columns, const std::vector<Candidate> &candidates,
                   const Unknowns &unknowns, std::vector<Fit> &fits)
{
    constexpr int kIterations = 20; // enough to see which candidates are worth a complete fit
    for (const Candidate &candidate : candidates) {
        fits.push_back(refined(observations, candidate.model, columns, unknowns, kIterations));
        if (isExact(observations, fits.back())) {
            return true;
        }
    }
    return false;
}

/// Fits the best two fits of some rows to more rows, and returns the better one.
Fit bestOf(const Observations &observations, std::vector<Fit> fits)
{
    constexpr std::size_t kFinalists = 2; // the best fit of some rows may be the second one of all
    Fit best;
    std::ranges::sort(fits, {}, &Fit::misfit);
    fits.resize(std::min(kFinalists, fits.size()));
    for (const Fit &start : fits) {
        Fit fit = refined(observations, start.model, start.columns, start.unknowns);
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
    Model model{.mechanism = given, .followsAngle = observations.angle.size() > 0};
    model.readings.resize(observations.columns.size());
    std::vector<Model> models;
    if (model.followsAngle) {
        for (const double unit : kAngleUnits) {
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

/// Appends the lowest derivative of a coordinate in the file, after `skipped` lower ones.
void appendLowest(Indices &columns, const Observations &observations, Coordinate coordinate, int skipped)
{
    int lowerOnes = 0;
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        const auto column =
            std::ranges::find(observations.columns, Channel{coordinate, order}, &ObservedColumn::channel);
        if (column == observations.columns.end() || column->range == 0.0) {
            continue;
        }
        if (lowerOnes == skipped) {
            columns.push_back(column - observations.columns.begin());
            return;
        }
        ++lowerOnes;
    }
}

} // namespace

Indices shapeColumns(const Observations &observations, int skipped)
{
    Indices columns;
    appendLowest(columns, observations, Theta3, skipped);
    appendLowest(columns, observations, R4x, skipped);
    if (columns.empty() && skipped == 0) {
        for (const Coordinate centre : {R3x, R3y, R2x, R2y}) {
            appendLowest(columns, observations, centre, skipped);
        }
    }
    const auto isPosition = [&](Index k) { return !observations.columns[k].isDerivative(); };
    if (observations.angle.size() > 0 && std::ranges::any_of(columns, isPosition)) {
        std::erase_if(columns, std::not_fn(isPosition));
    }
    return columns;
}

bool determineLengths(const Observations &observations, const Indices &columns)
{
    bool hasLength = false;
    bool hasSpeed = observations.time.size() > 0;
    for (const Index k : columns) {
        const Channel channel = observations.columns[k].channel;
        const bool isLength = !isAngle(channel.coordinate);
        hasLength = hasLength || isLength;
        hasSpeed = hasSpeed || isLength == (channel.order == Order::Position);
    }
    return hasLength && hasSpeed;
}

Fit findGeometry(const Observations &observations, const Indices &columns, const std::vector<double> &speeds,
                 const Parameters &given)
{
    constexpr Index kGridRows = 40;    // the grid is coarse, and has many points
    constexpr Index kSearchRows = 120; // some dozens of candidates are fitted to them
    const Observations gridRows = thinned(observations, kGridRows);
    const Observations searchRows = thinned(observations, kSearchRows);
    const bool followsAngle = observations.angle.size() > 0;
    const Unknowns unknownsWithUsualOrigins = geometryUnknowns(observations, columns, followsAngle, Origins::Usual);
    const Unknowns unknownsWithAnyOrigins = geometryUnknowns(observations, columns, followsAngle, Origins::Any);
    std::vector<Candidate> candidatesWithAnyOrigins;
    std::vector<Fit> fits;
    for (const Model &start : startModels(observations, speeds, given)) {
        const GridResult grid = searchGrid(gridRows, columns, start, given);
        std::ranges::copy(grid.anyOrigins, std::back_inserter(candidatesWithAnyOrigins));
        const bool isOneExact = fitCandidates(searchRows, columns, grid.usualOrigins, unknownsWithUsualOrigins, fits);
        if (isOneExact) {
            break;
        }
    }
    Fit fit = bestOf(observations, std::move(fits));
    if (isExact(observations, fit)) {
        return fit;
    }
    std::vector<Fit> fitsWithAnyOrigins;
    fitCandidates(searchRows, columns, candidatesWithAnyOrigins, unknownsWithAnyOrigins, fitsWithAnyOrigins);
    Fit other = bestOf(observations, std::move(fitsWithAnyOrigins));
    return other.misfit < fit.misfit ? other : fit;
}

double misfitOf(const Observations &observations, const Fit &geometry, const Indices &columns)
{
    constexpr int kIterations = 5; // enough, because the predictions are linear in the origins
    Unknowns origins;
    for (const Index k : columns) {
        if (!observations.columns[k].isDerivative()) {
            origins.push_back({Unknown::Kind::Origin, k});
        }
    }
    return geometry.isFinite() ? refined(observations, geometry.model, columns, origins, kIterations).misfit
                               : kInfinity;
}

double misfitAfterFit(const Observations &observations, const Fit &geometry, const Indices &columns)
{
    if (!geometry.isFinite()) {
        return kInfinity;
    }
    Model start = geometry.model;
    Unknowns unknowns = geometry.unknowns;
    for (const Index k : columns) {
        const ObservedColumn &column = observations.columns[k];
        const Unknown origin{Unknown::Kind::Origin, k};
        if (!geometry.uses(k)) {
            start.readings[k].factor = usualFactor(observations, geometry, k);
        }
        if (!column.isDerivative() && !geometry.changes(origin)) {
            unknowns.push_back(origin);
        }
    }
    return refined(observations, std::move(start), columns, unknowns).misfit;
}

} // namespace slidercrank
