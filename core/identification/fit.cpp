// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/fit.h"

#include "core/identification/minimizer.h"
#include "core/identification/noise.h"

#include "core/mechanism/turn.h"

#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/AutoDiff>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

/// A number with its partial derivatives by a, b, c and the angle of the crank.
using Dual = Eigen::AutoDiffScalar<Eigen::Vector4d>;

Dual independent(double value, int position)
{
    return {value, 4, position};
}

/// The partial derivatives of a prediction by each kind of unknown, and the residual behind them.
constexpr int kKinds = 6; // of Unknown::Kind
constexpr int kResidual = kKinds;
using Row = Eigen::Matrix<double, kKinds + 1, 1>;

/// Sums over the rows of a column.
struct ColumnSums {
    Eigen::Matrix<double, kKinds + 1, kKinds + 1> products = decltype(products)::Zero(); ///< of all pairs in a Row
    double count = 0.0;

    double meanSquare() const { return count > 0.0 ? products(kResidual, kResidual) / count : 0.0; }
};

/// Adds one row of the file to the sums. Returns false if the row has a value but the mechanism cannot be assembled.
bool addRow(std::vector<ColumnSums> &sums, const Model &model, const Observations &observations, const Indices &columns,
            Index row)
{
    const Parameters &m = model.mechanism;
    const double speed = model.crankSpeed(observations, row);
    const double angleBySpeed = model.followsAngle ? 0.0 : observations.time[row];
    TextbookMotion<Dual> motion;
    const bool isAssembled = moveTo<Dual>(motion, m, {independent(m.a, 0), independent(m.b, 1), independent(m.c, 2)},
                                          independent(model.crankAngle(observations, row), 3));
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const ObservedColumn &column = observations.columns[columns[k]];
        const ColumnReading &reading = model.readings[columns[k]];
        const double value = column.values[row];
        if (!std::isfinite(value)) {
            continue;
        }
        if (!isAssembled) {
            return false;
        }
        const Dual prediction = atSpeed(motion, column.channel, speed, model.alpha2);
        const auto [byA, byB, byC, byAngle] = std::array{prediction.derivatives()[0], prediction.derivatives()[1],
                                                         prediction.derivatives()[2], prediction.derivatives()[3]};
        double bySpeed = byAngle * angleBySpeed;
        if (column.isDerivative()) { // it has the power of the speed as a factor
            const double order = static_cast<double>(column.channel.order);
            bySpeed += order * std::pow(speed, order - 1.0) * motion.valueAt(column.channel).value();
        }
        const double f = reading.factor;
        Row entries;
        entries << f * byA, f * byB, f * byC, f * bySpeed, f * byAngle, 1.0,
            value - f * prediction.value() - reading.origin;
        sums[k].products.noalias() += entries * entries.transpose();
        sums[k].count += 1.0;
    }
    return true;
}

/// The part of the misfit that a column contributes with `count` values whose residuals have a mean square.
double columnMisfit(const ObservedColumn &column, double meanSquare, double count)
{
    return column.isConstant() ? meanSquare / column.variance : count * std::log(meanSquare + column.variance);
}

/// The derivative of columnMisfit() by the mean square.
double columnMisfitSlope(const ObservedColumn &column, double meanSquare, double count)
{
    return column.isConstant() ? 1.0 / column.variance : count / (meanSquare + column.variance);
}

/// The misfit of a model with its derivatives by the unknowns. nullopt if the mechanism cannot be assembled, or if the
/// computation was stopped.
std::optional<LocalShape> shapeOfMisfit(const Observations &observations, const Model &model, const Indices &columns,
                                        const Unknowns &unknowns)
{
    std::vector<ColumnSums> sums(columns.size());
    for (Index row = 0; row < observations.size(); ++row) {
        if (observations.stop.stop_requested() || !addRow(sums, model, observations, columns, row)) {
            return std::nullopt;
        }
    }
    const Index size = std::ssize(unknowns);
    LocalShape shape{0.0, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
    for (std::size_t k = 0; k < columns.size(); ++k) {
        // The derivative of n ln(RSS/n + step²/12) is that of RSS, divided by the variance RSS/n + step²/12. The second
        // derivatives are approximate: without those of the predictions and of the variance.
        const auto &products = sums[k].products;
        const ObservedColumn &column = observations.columns[columns[k]];
        const double weight =
            2.0 * columnMisfitSlope(column, sums[k].meanSquare(), sums[k].count) / std::max(sums[k].count, 1.0);
        // The parameters concern all columns; an origin concerns its own.
        const auto concerns = [&](Unknown unknown) { return unknown.isParameter() || unknown.column == columns[k]; };
        shape.value += columnMisfit(column, sums[k].meanSquare(), sums[k].count);
        for (Index i = 0; i < size; ++i) {
            const auto rowOfUnknown = static_cast<Index>(unknowns[i].kind); // of the products
            if (!concerns(unknowns[i])) {
                continue;
            }
            shape.gradient[i] -= weight * products(rowOfUnknown, kResidual);
            for (Index j = 0; j < size; ++j) {
                if (concerns(unknowns[j])) {
                    shape.curvature(i, j) += weight * products(rowOfUnknown, static_cast<Index>(unknowns[j].kind));
                }
            }
        }
    }
    return std::isfinite(shape.value) ? std::optional(std::move(shape)) : std::nullopt;
}

/// Eigenvalues and eigenvectors of D·matrix·D, where the diagonal matrix D makes the diagonal of the product 1.
struct Eigensystem {
    Eigen::VectorXd scale; ///< the diagonal of D
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};

Eigensystem decomposed(const Eigen::MatrixXd &matrix)
{
    Eigen::VectorXd scale = diagonalScale(matrix);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * matrix * scale.asDiagonal());
    return {.scale = std::move(scale), .values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

Model withValues(Model model, const Unknowns &unknowns, const Eigen::VectorXd &values)
{
    for (Index i = 0; i < values.size(); ++i) {
        valueOf(model, unknowns[i]) = values[i];
    }
    return model;
}

} // namespace

double &valueOf(Model &model, Unknown unknown)
{
    switch (unknown.kind) {
    case Unknown::Kind::A: return model.mechanism.a;
    case Unknown::Kind::B: return model.mechanism.b;
    case Unknown::Kind::C: return model.mechanism.c;
    case Unknown::Kind::Omega2: return model.mechanism.omega2;
    case Unknown::Kind::CrankAngle: return model.mechanism.theta20;
    case Unknown::Kind::Origin: break;
    }
    return model.readings[unknown.column].origin;
}

double valueOf(const Model &model, Unknown unknown)
{
    Model copy = model;
    return valueOf(copy, unknown);
}

bool Fit::uses(Index column) const
{
    return std::ranges::find(columns, column) != columns.end();
}

bool Fit::changes(Unknown unknown) const
{
    return positionOf(unknown) < std::ssize(unknowns);
}

Index Fit::positionOf(Unknown unknown) const
{
    return std::ranges::find(unknowns, unknown) - unknowns.begin();
}

void Fit::takeModelOf(const Fit &other)
{
    model = other.model;
    residuals = other.residuals;
    rms = other.rms;
    misfit = other.misfit;
}

double Fit::valueCount() const
{
    return std::accumulate(counts.begin(), counts.end(), 0.0);
}

Fit evaluated(const Observations &observations, Model model, Indices columns)
{
    Fit fit{.model = std::move(model), .columns = std::move(columns)};
    const bool isMechanism = fit.model.mechanism.a > 0.0 && fit.model.mechanism.b > 0.0;
    fit.residuals = -predictedIn(fit.model, observations, fit.columns);
    fit.misfit = isMechanism ? 0.0 : kInfinity;
    for (Index k = 0; k < fit.residuals.cols(); ++k) {
        const ObservedColumn &column = observations.columns[fit.columns[k]];
        fit.residuals.col(k) += column.values;
        const double count = static_cast<double>(column.values.isFinite().count());
        const bool isAssembled = static_cast<double>(fit.residuals.col(k).isFinite().count()) == count;
        const double meanSquare = finite(fit.residuals.col(k)).square().sum() / std::max(count, 1.0);
        fit.counts.push_back(count);
        fit.rms.push_back(std::sqrt(meanSquare));
        fit.misfit += isAssembled ? columnMisfit(column, meanSquare, count) : kInfinity;
    }
    return fit;
}

Fit refined(const Observations &observations, Model start, Indices columns, Unknowns unknowns, int iterationLimit)
{
    Eigen::VectorXd values(std::ssize(unknowns));
    std::ranges::transform(unknowns, values.begin(), [&](Unknown unknown) { return valueOf(start, unknown); });
    const auto misfit = [&](const Eigen::VectorXd &point) -> std::optional<LocalShape> {
        const Model model = withValues(start, unknowns, point);
        const bool isMechanism = model.mechanism.a > 0.0 && model.mechanism.b > 0.0;
        return isMechanism ? shapeOfMisfit(observations, model, columns, unknowns) : std::nullopt;
    };
    std::optional<Minimum> minimum = minimize(misfit, std::move(values), {.iterationLimit = iterationLimit});
    if (!minimum) {
        return {.model = std::move(start), .columns = std::move(columns), .unknowns = std::move(unknowns)};
    }
    Fit fit = evaluated(observations, withValues(std::move(start), unknowns, minimum->point), std::move(columns));
    fit.unknowns = std::move(unknowns);
    fit.gradient = std::move(minimum->shape.gradient);
    fit.curvature = std::move(minimum->shape.curvature);
    fit.iterations = minimum->iterations;
    return fit;
}

bool isShortArc(const Observations &observations, const Model &model)
{
    constexpr double kWholeTurn = 0.9 * kTurn; // rows every 30° may end at 330°
    double least = kInfinity;
    double greatest = -kInfinity;
    for (Index row = 0; row < observations.size(); ++row) {
        const double angle = model.crankAngle(observations, row);
        least = std::min(least, angle);
        greatest = std::max(greatest, angle);
    }
    return greatest - least < kWholeTurn;
}

double dependence(const Fit &fit)
{
    double largest = 1.0;
    for (Index k = 0; k < fit.residuals.cols(); ++k) {
        largest = std::max(largest, dependence(fit.residuals.col(k)));
    }
    return largest;
}

bool isNoise(const Fit &fit)
{
    bool isNoise = true;
    for (Index k = 0; k < fit.residuals.cols(); ++k) {
        isNoise = isNoise && changeSignLikeNoise(fit.residuals.col(k));
    }
    return isNoise;
}

Eigen::VectorXd stepToMinimum(const Fit &fit)
{
    const Eigen::VectorXd step = -0.5 * covarianceOf(fit) * fit.gradient; // the covariance is 2 curvature⁻¹
    return step.array().isFinite().select(step, 0.0);
}

double conditionNumber(const Fit &fit)
{
    const Eigen::VectorXd values = decomposed(fit.curvature).values;
    return std::sqrt(values.maxCoeff() / std::max(values.minCoeff(), kEpsilon * kEpsilon));
}

Eigen::MatrixXd covarianceOf(const Fit &fit)
{
    constexpr double kSmallestEigenvalue = 1e-19; // below, there are only rounding errors
    const Eigensystem system = decomposed(fit.curvature);
    const Eigen::VectorXd inverse = system.values.array().max(kSmallestEigenvalue).inverse();
    const Eigen::MatrixXd vectors = system.scale.asDiagonal() * system.vectors;
    return 2.0 * (vectors * inverse.asDiagonal() * vectors.transpose());
}

} // namespace slidercrank
