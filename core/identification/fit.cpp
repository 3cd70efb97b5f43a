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

/// One of the four variables of a Dual: its derivative by itself, the one at `index`, is 1.
Dual variable(double value, int index)
{
    return {value, 4, index};
}

/// The terms that belong to one value of a column: the partial derivatives of its prediction by the parameters, at
/// indexOf(Parameter), and by the origin of the column; and the residual.
constexpr Index kOriginTerm = static_cast<Index>(kParameterCount);
constexpr Index kResidualTerm = kOriginTerm + 1;
constexpr Index kTermCount = kResidualTerm + 1;
using Terms = Eigen::Matrix<double, kTermCount, 1>;

/// Sums over the values of a column.
struct ColumnSums {
    /// The sums of the products of all pairs of terms.
    Eigen::Matrix<double, kTermCount, kTermCount> products = decltype(products)::Zero();
    double count = 0.0; ///< number of values

    /// The mean square of the residuals.
    double meanSquare() const { return count > 0.0 ? products(kResidualTerm, kResidualTerm) / count : 0.0; }
};

/// The terms of column k in one row, with the motion of the mechanism there.
Terms computeTerms(const TextbookMotion<Dual> &motion, const Model &model, const Observations &observations, Index k,
                   Index row)
{
    const ObservedColumn &column = observations.columns[k];
    const ColumnReading &reading = model.readings[k];
    const double speed = model.crankSpeed(observations, row);
    const Dual motionOfColumn = motionAtSpeed(motion, column.channel, speed, model.alpha2);
    const auto [byA, byB, byC, byAngle] = std::array{motionOfColumn.derivatives()[0], motionOfColumn.derivatives()[1],
                                                     motionOfColumn.derivatives()[2], motionOfColumn.derivatives()[3]};
    // ω2 changes the angle of the crank, which is ω2 t + θ20 unless the model follows the angle in the file.
    double bySpeed = model.followsAngle ? 0.0 : byAngle * observations.time.values[row];
    // ω2 also changes a derivative at this angle: the derivative of f'ω by ω is f', that of f''ω² + f'α is 2 f''ω.
    if (column.isDerivative()) {
        const double order = static_cast<double>(column.channel.order);
        bySpeed += order * std::pow(speed, order - 1.0) * motion.valueAt(column.channel).value();
    }
    const double factor = reading.factor;
    const double byOrigin = 1.0;
    const double residual = column.values[row] - factor * motionOfColumn.value() - reading.origin;
    Terms terms;
    terms << factor * byA, factor * byB, factor * byC, factor * bySpeed, factor * byAngle, byOrigin, residual;
    return terms;
}

/// Adds the terms of one row to the sums of the columns. Returns false if the row has a value but the mechanism cannot
/// be assembled.
bool addTermsOfRow(std::vector<ColumnSums> &sums, const Model &model, const Observations &observations,
                   const Indices &columns, Index row)
{
    const Parameters &m = model.mechanism;
    TextbookMotion<Dual> motion;
    const bool isAssembled =
        computeUnitSpeedMotion<Dual>(motion, m.branch, {variable(m.a, 0), variable(m.b, 1), variable(m.c, 2)},
                                     variable(model.crankAngle(observations, row), 3), model.isApproximateFormula);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Index k = columns[i];
        if (!std::isfinite(observations.columns[k].values[row])) {
            continue;
        }
        if (!isAssembled) {
            return false;
        }
        const Terms terms = computeTerms(motion, model, observations, k, row);
        sums[i].products.noalias() += terms * terms.transpose();
        sums[i].count += 1.0;
    }
    return true;
}

/// The part of the misfit that a column contributes; a constant one counts like a single value (fit.h). `count`: number
/// of its values; `meanSquare`: mean square of their residuals.
double columnMisfit(const ObservedColumn &column, double meanSquare, double count)
{
    return column.isConstant() ? meanSquare / column.variance : count * std::log(meanSquare + column.variance);
}

/// The derivative of columnMisfit() with respect to the mean square.
double columnMisfitSlope(const ObservedColumn &column, double meanSquare, double count)
{
    return column.isConstant() ? 1.0 / column.variance : count / (meanSquare + column.variance);
}

/// Adds the part that a column contributes to the misfit and to its derivatives by the unknowns. `sums`: the
/// sums of this column.
void addMisfitOfColumn(LocalShape &shape, const ColumnSums &sums, const Observations &observations, Index columnIndex,
                       const Unknowns &unknowns)
{
    const ObservedColumn &column = observations.columns[columnIndex];
    const double meanSquare = sums.meanSquare();
    shape.value += columnMisfit(column, meanSquare, sums.count);
    // RSS is the sum of r² of the residuals r. With the derivatives p of a prediction by the unknowns, the gradient of
    // r² is -2 r p, and its second derivatives are 2 p pᵀ if those of the prediction are neglected. The misfit has the
    // same derivatives, times its derivative by RSS. In the second derivatives, the change of this factor is neglected,
    // too.
    const double weight = 2.0 * columnMisfitSlope(column, meanSquare, sums.count) / std::max(sums.count, 1.0);
    // A parameter changes the predictions of all columns, an origin only those of its own column.
    const auto changesColumn = [&](Unknown unknown) { return !unknown.isOrigin() || unknown.column == columnIndex; };
    const auto termOf = [](Unknown unknown) {
        return unknown.parameter ? static_cast<Index>(indexOf(*unknown.parameter)) : kOriginTerm;
    };
    for (Index i = 0; i < std::ssize(unknowns); ++i) {
        if (!changesColumn(unknowns[i])) {
            continue;
        }
        shape.gradient[i] -= weight * sums.products(termOf(unknowns[i]), kResidualTerm);
        for (Index j = 0; j < std::ssize(unknowns); ++j) {
            if (changesColumn(unknowns[j])) {
                shape.curvature(i, j) += weight * sums.products(termOf(unknowns[i]), termOf(unknowns[j]));
            }
        }
    }
}

bool hasPositiveLinks(const Parameters &mechanism)
{
    return mechanism.a > 0.0 && mechanism.b > 0.0;
}

/// The misfit of a model with its derivatives by the unknowns. nullopt if the mechanism cannot be assembled, or if the
/// computation was stopped.
std::optional<LocalShape> shapeOfMisfit(const Observations &observations, const Model &model, const Indices &columns,
                                        const Unknowns &unknowns)
{
    std::vector<ColumnSums> sums(columns.size());
    for (Index row = 0; row < observations.size(); ++row) {
        if (observations.stop.stop_requested() || !addTermsOfRow(sums, model, observations, columns, row)) {
            return std::nullopt;
        }
    }
    const Index size = std::ssize(unknowns);
    LocalShape shape{0.0, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        addMisfitOfColumn(shape, sums[i], observations, columns[i], unknowns);
    }
    return std::isfinite(shape.value) ? std::optional(std::move(shape)) : std::nullopt;
}

/// Eigenvalues and eigenvectors of D·curvature·D, where the diagonal matrix D makes the diagonal of the product 1.
struct Eigensystem {
    Eigen::VectorXd scale;  ///< the diagonal of D
    Eigen::VectorXd values; ///< positive
    Eigen::MatrixXd vectors;
};

Eigensystem scaledEigensystem(const Eigen::MatrixXd &curvature)
{
    // The eigenvalue of a combination of unknowns that the columns do not determine is 0 apart from rounding errors,
    // which may make it negative. This bound makes its variance positive, finite and very large.
    constexpr double kSmallestEigenvalue = kEpsilon * kEpsilon;
    Eigen::VectorXd scale = diagonalScale(curvature);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * curvature * scale.asDiagonal());
    return {.scale = std::move(scale),
            .values = solver.eigenvalues().cwiseMax(kSmallestEigenvalue),
            .vectors = solver.eigenvectors()};
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
    return unknown.parameter ? valueOf(model.mechanism, *unknown.parameter) : model.readings[unknown.column].origin;
}

double valueOf(const Model &model, Unknown unknown)
{
    return unknown.parameter ? valueOf(model.mechanism, *unknown.parameter) : model.readings[unknown.column].origin;
}

double parameterSize(Parameter parameter, const Parameters &parameters)
{
    switch (parameter) {
    case Parameter::A: return parameters.a;
    case Parameter::B: return parameters.b;
    case Parameter::C: return std::max(parameters.a, std::abs(parameters.c));
    case Parameter::Omega2: return std::abs(parameters.omega2);
    case Parameter::Theta20: break;
    }
    return 1.0;
}

bool Fit::usesColumn(Index column) const
{
    return std::ranges::find(columns, column) != columns.end();
}

bool Fit::isFree(Unknown unknown) const
{
    return indexOf(unknown) < std::ssize(unknowns);
}

Index Fit::indexOf(Unknown unknown) const
{
    return std::ranges::find(unknowns, unknown) - unknowns.begin();
}

Unknowns Fit::unknownsWith(const Unknowns &more) const
{
    Unknowns result = unknowns;
    std::ranges::copy_if(more, std::back_inserter(result), [this](Unknown unknown) { return !isFree(unknown); });
    return result;
}

void Fit::replaceModel(const Fit &other)
{
    model = other.model;
    residuals = other.residuals;
    rms = other.rms;
    misfit = other.misfit;
}

Indices Fit::indicesInFit() const
{
    Indices indicesInFit(static_cast<std::size_t>(residuals.cols()));
    std::iota(indicesInFit.begin(), indicesInFit.end(), Index{0});
    return indicesInFit;
}

double Fit::valueCount() const
{
    return std::accumulate(counts.begin(), counts.end(), 0.0);
}

double columnMisfit(const Observations &observations, const Fit &fit, Index indexInFit)
{
    const double meanSquare = fit.rms[indexInFit] * fit.rms[indexInFit];
    return columnMisfit(observations.columns[fit.columns[indexInFit]], meanSquare, fit.counts[indexInFit]);
}

Fit evaluateModel(const Observations &observations, Model model, Indices columns)
{
    Fit fit{.model = std::move(model), .columns = std::move(columns)};
    fit.residuals = -predictValues(fit.model, observations, fit.columns);
    fit.misfit = hasPositiveLinks(fit.model.mechanism) ? 0.0 : kInfinity;
    for (const Index indexInFit : fit.indicesInFit()) {
        const ObservedColumn &column = observations.columns[fit.columns[indexInFit]];
        fit.residuals.col(indexInFit) += column.values;
        const double count = static_cast<double>(column.values.isFinite().count());
        // The predictions are NaN where the mechanism cannot be assembled.
        const bool isAssembled = static_cast<double>(fit.residuals.col(indexInFit).isFinite().count()) == count;
        const double meanSquare = gapsAsZeros(fit.residuals.col(indexInFit)).square().sum() / std::max(count, 1.0);
        fit.counts.push_back(count);
        fit.rms.push_back(std::sqrt(meanSquare));
        fit.misfit += isAssembled ? columnMisfit(column, meanSquare, count) : kInfinity;
    }
    return fit;
}

Fit fitModel(const Observations &observations, Model start, Indices columns, Unknowns unknowns, int iterationLimit)
{
    Eigen::VectorXd values(std::ssize(unknowns));
    std::ranges::transform(unknowns, values.begin(), [&](Unknown unknown) { return valueOf(start, unknown); });
    const auto misfit = [&](const Eigen::VectorXd &point) -> std::optional<LocalShape> {
        const Model model = withValues(start, unknowns, point);
        return hasPositiveLinks(model.mechanism) ? shapeOfMisfit(observations, model, columns, unknowns) : std::nullopt;
    };
    std::optional<Minimum> minimum = minimize(misfit, std::move(values), {.iterationLimit = iterationLimit});
    if (!minimum) {
        return {.model = std::move(start), .columns = std::move(columns), .unknowns = std::move(unknowns)};
    }
    Fit fit = evaluateModel(observations, withValues(std::move(start), unknowns, minimum->point), std::move(columns));
    fit.unknowns = std::move(unknowns);
    fit.gradient = std::move(minimum->shape.gradient);
    fit.curvature = std::move(minimum->shape.curvature);
    fit.iterations = minimum->iterations;
    return fit;
}

bool isShortArc(const Observations &observations, const Model &model)
{
    constexpr double kWholeTurn = 0.9 * kTurn; // rows every 30° may end at 330°
    ValueRange angles;
    for (Index row = 0; row < observations.size(); ++row) {
        angles.include(model.crankAngle(observations, row));
    }
    return angles.width() < kWholeTurn;
}

double dependence(const Fit &fit)
{
    double largest = 1.0;
    for (const Index indexInFit : fit.indicesInFit()) {
        largest = std::max(largest, dependence(fit.residuals.col(indexInFit)));
    }
    return largest;
}

Eigen::VectorXd stepToMinimum(const Fit &fit)
{
    const Eigen::VectorXd step = -0.5 * computeCovariance(fit) * fit.gradient; // the covariance is 2 curvature⁻¹
    return step.array().isFinite().select(step, 0.0);
}

double conditionNumber(const Fit &fit)
{
    const Eigen::VectorXd values = scaledEigensystem(fit.curvature).values; // proportional to inverse squared errors
    return std::sqrt(values.maxCoeff() / values.minCoeff());
}

Eigen::MatrixXd computeCovariance(const Fit &fit)
{
    const Eigensystem system = scaledEigensystem(fit.curvature);
    const Eigen::VectorXd inverse = system.values.cwiseInverse();
    const Eigen::MatrixXd vectors = system.scale.asDiagonal() * system.vectors;
    // The covariance is the inverse of the second derivatives of S/2, which is minus the logarithm of the likelihood.
    // The curvature approximates those of S.
    return 2.0 * (vectors * inverse.asDiagonal() * vectors.transpose());
}

double standardErrorOrZero(const Fit &fit, Unknown unknown)
{
    const Index k = fit.indexOf(unknown);
    return fit.isFree(unknown) ? std::sqrt(computeCovariance(fit)(k, k)) : 0.0;
}

} // namespace slidercrank
