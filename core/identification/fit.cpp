// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/fit.h"

#include "core/identification/least_squares.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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
    constexpr int kBisections = 30;
    for (int k = 0; k < kBisections; ++k) {
        const double middle = 0.5 * (low + high);
        (meanRatio(middle) > 1.0 ? low : high) = middle;
    }
    return high;
}

/// Computes residuals, variances and noise at the unknowns of the hypothesis. Returns false if the mechanism cannot be
/// assembled in some row.
bool weigh(const Observations &data, Fit &fit)
{
    constexpr double kDoublePrecision = 1e-15; // relative to the largest angle, with some margin
    const std::size_t columnCount = data.columns.size();
    fit.residuals.assign(columnCount, std::vector<double>(data.abscissa.size(), kNone));
    fit.variances = fit.residuals;
    const UnknownLayout layout(fit.hypothesis.columns);
    const Eigen::VectorXd &q = fit.hypothesis.unknowns;
    const double rate = phaseRate(data, fit.hypothesis, q);
    const double angleError = std::abs(rate) * (0.5 * data.span() + std::abs(data.origin)) * kDoublePrecision;
    const double roundingOfAngle = rate * fit.hypothesis.abscissaStep;
    const double angleVariance = roundingOfAngle * roundingOfAngle / 12.0 + angleError * angleError;
    const auto record = [&](std::size_t row, std::size_t j, const Dual &model, double residual) {
        const double factor = fit.hypothesis.columns[j].factor();
        const double slope = layout.scaleOf(j, q) * model.derivatives()[4];
        fit.residuals[j][row] = residual;
        fit.variances[j][row] = factor * factor * data.columns[j].variances[row] + slope * slope * angleVariance;
    };
    if (!forEachResidual<Dual>(data, fit.hypothesis, q, record)) {
        return false;
    }
    fit.noiseVariances.assign(columnCount, 0.0);
    double common = 0.0; // sum of the noise in units of the columns' spreads
    double varying = 0.0;
    for (std::size_t j = 0; j < columnCount; ++j) {
        const ObservedColumn &column = data.columns[j];
        const double spread = column.spread * fit.hypothesis.columns[j].factor();
        if (fit.hypothesis.columns[j].isUsed && column.count > 0.0) {
            fit.noiseVariances[j] = noiseVarianceOf(fit.residuals[j], fit.variances[j], column.count);
            common += column.varies ? fit.noiseVariances[j] / (spread * spread) : 0.0;
            varying += column.varies ? 1.0 : 0.0;
        }
    }
    for (std::size_t j = 0; j < columnCount; ++j) {
        const double spread = data.columns[j].spread * fit.hypothesis.columns[j].factor();
        const bool isBalanced = fit.hypothesis.isBalanced && data.columns[j].varies;
        for (double &variance : fit.variances[j]) {
            variance += isBalanced ? common / varying * spread * spread : fit.noiseVariances[j];
        }
    }
    return true;
}

/// S = Σ [r²/V + ln(V/z²)] + k ln N with the spread z of the column. A column that is not used counts as a column whose
/// noise is its spread.
void computeScore(const Observations &data, Fit &fit)
{
    double values = 0.0;
    fit.chiSquare = fit.score = 0.0;
    for (std::size_t j = 0; j < data.columns.size(); ++j) {
        const double spread = data.columns[j].spread * std::abs(fit.hypothesis.columns[j].factor());
        if (!fit.hypothesis.columns[j].isUsed) {
            fit.score += data.columns[j].count;
            continue;
        }
        for (std::size_t i = 0; i < data.abscissa.size(); ++i) {
            if (!std::isnan(fit.residuals[j][i])) {
                fit.chiSquare += fit.residuals[j][i] * fit.residuals[j][i] / fit.variances[j][i];
                fit.score += std::log(fit.variances[j][i] / (spread * spread));
                values += 1.0;
            }
        }
    }
    fit.score += fit.chiSquare + static_cast<double>(fit.hypothesis.freeParameterCount()) * std::log(values);
}

/// Starts new offsets where the mean residual of their column is zero.
void startOffsets(const Observations &data, Hypothesis &hypothesis)
{
    const UnknownLayout layout(hypothesis.columns);
    const Eigen::Index given = hypothesis.unknowns.size();
    if (given >= layout.size) {
        return;
    }
    hypothesis.unknowns.conservativeResize(layout.size);
    hypothesis.unknowns.tail(layout.size - given).setZero();
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(layout.size);
    forEachResidual<double>(data, hypothesis, hypothesis.unknowns,
                            [&](std::size_t, std::size_t j, double, double residual) {
                                if (layout.offset[j] >= 0) {
                                    mean[layout.offset[j]] -= residual / data.columns[j].count;
                                }
                            });
    hypothesis.unknowns += mean;
}

/// One round of Levenberg-Marquardt with fixed variances; returns chi-square before and after.
std::pair<double, double> minimize(const Observations &data, Fit &fit)
{
    constexpr int kMostSteps = 12;
    constexpr int kMostTrials = 8;
    constexpr double kSmallGain = 1e-5; // of chi-square
    constexpr double kNoGain = 1e-4;
    constexpr double kUndamped = 1e-12;
    const bool hasScales = std::ranges::any_of(fit.hypothesis.columns, &ColumnUse::hasScale);
    const double first = chiSquareAt(data, fit, fit.hypothesis.unknowns);
    double chiSquare = first;
    double lambda = 1e-3;
    for (int step = 0; step < kMostSteps; ++step) {
        ++fit.iterations;
        const NormalEquations equations = normalEquations(data, fit, fit.hypothesis.unknowns);
        double gain = 0.0;
        for (int trial = 0; trial < kMostTrials; ++trial, lambda *= 10.0) {
            Eigen::VectorXd unknowns =
                fit.hypothesis.unknowns - solveSymmetric(equations.matrix, equations.gradient, lambda).col(0);
            if (hasScales) {
                regressScales(data, fit.hypothesis, unknowns);
            }
            const double tried = chiSquareAt(data, fit, unknowns);
            if (tried < chiSquare) {
                gain = chiSquare - tried;
                chiSquare = tried;
                fit.hypothesis.unknowns = unknowns;
                lambda = std::max(lambda * 0.05, kUndamped);
                break;
            }
            if (tried <= chiSquare * (1.0 + kSmallGain) + kNoGain) { // only rounding errors of the computation remain
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

void regressScales(const Observations &data, const Hypothesis &hypothesis, Eigen::VectorXd &unknowns)
{
    const UnknownLayout layout(hypothesis.columns);
    unknowns.conservativeResize(layout.size);
    Hypothesis at = hypothesis;
    at.unknowns = unknowns;
    const std::vector<ColumnRegression> regressions = columnRegressions(data, at);
    for (std::size_t j = 0; j < regressions.size(); ++j) {
        if (layout.scale[j] >= 0) {
            unknowns[layout.scale[j]] = regressions[j].slope();
            unknowns[layout.offset[j]] = regressions[j].offset(1.0, regressions[j].slope());
        }
    }
}

double chiSquareAt(const Observations &data, const Fit &fit, const Eigen::VectorXd &unknowns)
{
    double sum = 0.0;
    const bool moves = forEachResidual<double>(data, fit.hypothesis, unknowns,
                                               [&](std::size_t row, std::size_t j, double, double residual) {
                                                   sum += residual * residual / fit.variances[j][row];
                                               });
    return moves && std::isfinite(sum) ? sum : kInfinity;
}

NormalEquations normalEquations(const Observations &data, const Fit &fit, const Eigen::VectorXd &unknowns)
{
    const UnknownLayout layout(fit.hypothesis.columns);
    NormalEquations equations{Eigen::MatrixXd::Zero(layout.size, layout.size), Eigen::VectorXd::Zero(layout.size)};
    Eigen::MatrixXd &matrix = equations.matrix;
    const auto add = [&](std::size_t row, std::size_t j, const Dual &model, double residual) {
        std::array<Eigen::Index, kParameterCount + 2> index;
        std::array<double, kParameterCount + 2> slope;
        std::size_t count = 0;
        const double scale = layout.scaleOf(j, unknowns);
        for (std::size_t k = 0; k < kParameterCount; ++k) {
            if (fit.hypothesis.isFree[k]) {
                index[count] = static_cast<Eigen::Index>(k);
                slope[count++] = scale * model.derivatives()[static_cast<Eigen::Index>(k)];
            }
        }
        if (layout.offset[j] >= 0) {
            index[count] = layout.offset[j];
            slope[count++] = 1.0;
        }
        if (layout.scale[j] >= 0) {
            index[count] = layout.scale[j];
            slope[count++] = model.value();
        }
        const double weight = 1.0 / fit.variances[j][row];
        for (std::size_t k = 0; k < count; ++k) {
            equations.gradient[index[k]] += weight * slope[k] * residual;
            for (std::size_t l = 0; l <= k; ++l) {
                matrix(index[k], index[l]) += weight * slope[k] * slope[l];
            }
        }
    };
    forEachResidual<Dual>(data, fit.hypothesis, unknowns, add);
    for (Eigen::Index k = 0; k < layout.size; ++k) {
        matrix(k, k) = matrix(k, k) > 0.0 ? matrix(k, k) : 1.0;
        for (Eigen::Index l = 0; l < k; ++l) {
            matrix(l, k) = matrix(k, l);
        }
    }
    return equations;
}

Fit evaluateHypothesis(const Observations &data, Hypothesis hypothesis)
{
    Fit fit{std::move(hypothesis), {}, {}, {}};
    startOffsets(data, fit.hypothesis);
    if (!fit.hypothesis.unknowns.allFinite() || !weigh(data, fit)) {
        return {};
    }
    computeScore(data, fit);
    return fit;
}

Fit fitHypothesis(const Observations &data, Hypothesis hypothesis, int rounds)
{
    constexpr double kSettled = 1e-3; // relative change of chi-square and of the noise from round to round
    Fit fit{std::move(hypothesis), {}, {}, {}};
    startOffsets(data, fit.hypothesis);
    double noiseBefore = kInfinity;
    for (int round = 0; round < rounds; ++round) {
        if (!weigh(data, fit)) {
            return {};
        }
        const auto [first, last] = minimize(data, fit);
        double noise = 0.0;
        for (std::size_t j = 0; j < data.columns.size(); ++j) {
            noise += fit.noiseVariances[j] > 0.0 ? data.columns[j].count * std::log(fit.noiseVariances[j]) : 0.0;
        }
        if (round > 0 && first - last <= kSettled * (last + 1.0) &&
            std::abs(noise - noiseBefore) <= kSettled * static_cast<double>(data.abscissa.size())) {
            break;
        }
        noiseBefore = noise;
    }
    const int iterations = fit.iterations;
    if (fit.hypothesis.unknowns[0] < 0.0) { // a positive crank half a turn on, which a column of θ2 contradicts
        fit.hypothesis.unknowns[0] *= -1.0;
        fit.hypothesis.unknowns[4] += std::numbers::pi;
    }
    Fit settled = evaluateHypothesis(data, std::move(fit.hypothesis));
    settled.iterations = iterations;
    return settled;
}

} // namespace slidercrank
