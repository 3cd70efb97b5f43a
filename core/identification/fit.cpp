// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/fit.h"

#include "core/identification/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

/// The variance that must be added to the variances of a column so that the mean of r²/V is 1; 0 if rounding explains
/// the residuals.
double noiseVarianceOf(const std::vector<double> &residuals, const std::vector<double> &variances, double count)
{
    const auto meanRatio = [&](double noise) {
        double sum = 0.0;
        for (std::size_t i = 0; i < residuals.size(); ++i) {
            sum += std::isnan(residuals[i]) ? 0.0 : residuals[i] * residuals[i] / (variances[i] + noise);
        }
        return sum / count;
    };
    // The square of a uniformly distributed value has a variance of 0.8 times its squared mean: allow five standard
    // deviations.
    const double largestOfRounding = 1.0 + 5.0 * std::sqrt(0.8 / count) + 5.0 / count;
    if (!(meanRatio(0.0) > largestOfRounding)) {
        return 0.0;
    }
    double low = 0.0;
    double high = 0.0;
    for (const double residual : residuals) {
        high += std::isnan(residual) ? 0.0 : residual * residual / count;
    }
    constexpr int kBisections = 20;
    for (int k = 0; k < kBisections; ++k) {
        const double middle = 0.5 * (low + high);
        (meanRatio(middle) > 1.0 ? low : high) = middle;
    }
    return high;
}

/// Computes residuals, variances, noise and their sums at the unknowns of the hypothesis. Returns false if the
/// mechanism cannot be assembled in some row.
bool weigh(const Observations &data, Fit &fit)
{
    constexpr double kDoublePrecision = 1e-15; // relative to the largest angle, with some margin
    const std::size_t columnCount = data.columns.size();
    const Hypothesis &hypothesis = fit.hypothesis;
    fit.residuals.assign(columnCount, std::vector<double>(data.abscissa.size(), kNone));
    fit.variances = fit.residuals;
    fit.noiseVariances.assign(columnCount, 0.0);
    fit.noiseParts = fit.noiseVariances;
    fit.chiSquare = fit.logVariance = fit.valueCount = 0.0;
    const double rate = hypothesis.phaseRate(data);
    const double angleError = rate * (0.5 * data.span() + std::abs(data.origin)) * kDoublePrecision;
    const double roundingOfAngle = rate * hypothesis.abscissaStep;
    // All columns of a row share the rounding of its abscissa, which is one error, not one for each column.
    const auto columnsOfRow = static_cast<double>(std::ranges::count(hypothesis.columns, true, &ColumnUse::isUsed));
    const double angleVariance = columnsOfRow * (roundingOfAngle * roundingOfAngle / 12.0 + angleError * angleError);
    const auto record = [&](std::size_t row, std::size_t j, const Dual &model, double residual) {
        const double factor = hypothesis.columns[j].factor();
        const double slope = hypothesis.scale(j) * model.derivatives()[4];
        fit.residuals[j][row] = residual;
        fit.variances[j][row] = factor * factor * data.columns[j].variances[row] + slope * slope * angleVariance;
    };
    if (!forEachResidual<Dual>(data, hypothesis, record)) {
        return false;
    }
    for (std::size_t j = 0; j < columnCount; ++j) {
        if (hypothesis.columns[j].isUsed && data.columns[j].count > 0.0) {
            fit.noiseVariances[j] = noiseVarianceOf(fit.residuals[j], fit.variances[j], data.columns[j].count);
            const double spread = interpretedSpread(data, hypothesis, j);
            fit.noiseParts[j] = data.columns[j].varies ? fit.noiseVariances[j] / (spread * spread) : 0.0;
        }
    }
    for (std::size_t j = 0; j < columnCount; ++j) {
        const double spread = interpretedSpread(data, hypothesis, j);
        for (std::size_t i = 0; i < data.abscissa.size(); ++i) {
            double &variance = fit.variances[j][i];
            variance += fit.noiseVariances[j];
            if (const double residual = fit.residuals[j][i]; !std::isnan(residual)) {
                fit.chiSquare += residual * residual / variance;
                fit.logVariance += std::log(variance / (spread * spread));
                fit.valueCount += 1.0;
            }
        }
    }
    return true;
}

/// One round of Levenberg-Marquardt with fixed variances; returns chi-square before and after.
std::pair<double, double> minimize(const Observations &data, Fit &fit)
{
    constexpr int kMostSteps = 8;
    constexpr int kMostTrials = 4;
    constexpr double kSmallGain = 1e-5; // of chi-square
    constexpr double kNoGain = 1e-4;
    constexpr double kUndamped = 1e-12;
    const bool hasScales = std::ranges::any_of(fit.hypothesis.columns, &ColumnUse::hasScale);
    const double first = chiSquareOf(data, fit, fit.hypothesis);
    double chiSquare = first;
    double lambda = 1e-3;
    for (int step = 0; step < kMostSteps; ++step) {
        ++fit.iterations;
        const NormalEquations equations = normalEquations<0>(data, fit, Eigen::MatrixXd(0, std::ssize(data.abscissa)));
        double gain = 0.0;
        for (int trial = 0; trial < kMostTrials; ++trial, lambda *= 10.0) {
            Hypothesis tried = fit.hypothesis;
            tried.unknowns -= solveSymmetric(equations.matrix, equations.gradient, lambda).col(0);
            if (hasScales) {
                regressScales(data, tried);
            }
            const double triedSquare = chiSquareOf(data, fit, tried);
            if (triedSquare < chiSquare) {
                gain = chiSquare - triedSquare;
                chiSquare = triedSquare;
                fit.hypothesis = std::move(tried);
                lambda = std::max(lambda * 0.05, kUndamped);
                break;
            }
            if (triedSquare <=
                chiSquare * (1.0 + kSmallGain) + kNoGain) { // only rounding errors of the computation remain
                break;
            }
        }
        if (gain <= kSmallGain * chiSquare + kNoGain) {
            if (lambda <= kUndamped) {
                break;
            }
            lambda = kUndamped; // the damping may have stopped it in a narrow valley
        }
    }
    return {first, chiSquare};
}

} // namespace

void regressScales(const Observations &data, Hypothesis &hypothesis)
{
    const std::vector<ColumnRegression> regressions = columnRegressions(data, hypothesis);
    for (std::size_t j = 0; j < regressions.size(); ++j) {
        if (hypothesis.columns[j].isUsed && hypothesis.columns[j].hasScale) {
            const double scale = regressions[j].slope();
            const Eigen::Index k = Hypothesis::offsetIndex(j);
            hypothesis.unknowns[k] = regressions[j].offset(1.0, scale);
            hypothesis.unknowns[k + 1] = scale;
        }
    }
}

double chiSquareOf(const Observations &data, const Fit &fit, const Hypothesis &hypothesis)
{
    double sum = 0.0;
    const bool moves =
        forEachResidual<double>(data, hypothesis, [&](std::size_t row, std::size_t j, double, double residual) {
            sum += residual * residual / fit.variances[j][row];
        });
    return moves && std::isfinite(sum) ? sum : kInfinity;
}

template <int kErrors>
NormalEquations normalEquations(const Observations &data, const Fit &fit, const Eigen::MatrixXd &errors)
{
    constexpr int kCount = kParameterCount + 2 + kErrors;
    using Block = Eigen::Matrix<double, kCount + 1, kCount + 1>; // of a column; the last column is its gradient
    const Hypothesis &hypothesis = fit.hypothesis;
    const Eigen::Index unknowns = hypothesis.unknowns.size();
    const Eigen::Index size = unknowns + kErrors * std::ssize(data.columns);
    NormalEquations equations{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
    Eigen::MatrixXd &matrix = equations.matrix;
    std::vector<Block> blocks(data.columns.size(), Block::Zero());
    Eigen::Matrix<double, kCount + 1, 1> slope;
    forEachResidual<Dual>(data, hypothesis, [&](std::size_t row, std::size_t j, const Dual &model, double residual) {
        slope << hypothesis.scale(j) * model.derivatives().head<kParameterCount>(), 1.0, model.value(),
            errors.col(static_cast<Eigen::Index>(row)), residual;
        blocks[j].noalias() += slope * (slope / fit.variances[j][row]).transpose();
    });
    for (std::size_t j = 0; j < blocks.size(); ++j) {
        const Eigen::Index offset = Hypothesis::offsetIndex(j);
        std::array<Eigen::Index, kCount> index{0, 1, 2, 3, 4, offset, offset + 1};
        std::iota(index.end() - kErrors, index.end(), unknowns + kErrors * static_cast<Eigen::Index>(j));
        equations.gradient(index) += blocks[j].template topRightCorner<kCount, 1>();
        matrix(index, index) += blocks[j].template topLeftCorner<kCount, kCount>();
    }
    for (Eigen::Index k = 0; k < unknowns; ++k) {
        if (!hypothesis.isFreeUnknown(k) || !(matrix(k, k) > 0.0)) {
            matrix.row(k).setZero();
            matrix.col(k).setZero();
            matrix(k, k) = 1.0;
            equations.gradient[k] = 0.0;
        }
    }
    return equations;
}

template NormalEquations normalEquations<kErrorsOfColumn>(const Observations &, const Fit &, const Eigen::MatrixXd &);

Fit evaluateHypothesis(const Observations &data, Hypothesis hypothesis)
{
    Fit fit{std::move(hypothesis)};
    if (!fit.hypothesis.unknowns.allFinite() || !weigh(data, fit)) {
        return {};
    }
    // S = Σ [r²/V + ln(V/z²)] + k ln N. A column that is not used counts as a column whose noise is its spread.
    fit.score = 0.0;
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        fit.score += fit.hypothesis.columns[j].isUsed ? 0.0 : data.columns[j].count;
    }
    for (Eigen::Index k = 0; k < fit.hypothesis.unknowns.size(); ++k) {
        fit.freeCount += fit.hypothesis.isFreeUnknown(k) ? 1.0 : 0.0;
    }
    fit.score += fit.chiSquare + fit.logVariance + fit.freeCount * std::log(fit.valueCount);
    return fit;
}

Fit fitHypothesis(const Observations &data, Hypothesis hypothesis, int rounds)
{
    constexpr double kSettled = 1e-3; // relative change of chi-square in a round
    Fit fit{std::move(hypothesis)};
    for (int round = 0; round < rounds; ++round) {
        if (!weigh(data, fit)) {
            return {};
        }
        const auto [first, last] = minimize(data, fit);
        if (round > 0 && first - last <= kSettled * (last + 1.0)) {
            break;
        }
    }
    if (fit.hypothesis.unknowns[0] < 0.0) { // a positive crank half a turn on, which a column of θ2 contradicts
        fit.hypothesis.unknowns[0] *= -1.0;
        fit.hypothesis.unknowns[4] += std::numbers::pi;
    }
    Fit settled = evaluateHypothesis(data, std::move(fit.hypothesis));
    settled.iterations = fit.iterations;
    return settled;
}

} // namespace slidercrank
