// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion_fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Weights 1/V of the values, by column.
using Weights = std::vector<std::vector<double>>;

/// The free numbers of a fit, added to.
void addStep(Fit &fit, const FreeParameters &isFree, Eigen::Index zeroCount, const FitVector &step)
{
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        if (isFree[i]) {
            valueOf(fit.parameters, static_cast<Parameter>(i)) += step[next++];
        }
    }
    for (Eigen::Index i = 0; i < zeroCount; ++i) {
        fit.zeros[static_cast<std::size_t>(i)] += step[next++];
    }
}

/// Σ w r², and, where asked for, the normal equations.
struct Linearized {
    double chiSquared = kInfinity;
    FitMatrix matrix;
    FitVector gradient;
};

constexpr std::size_t kMostUnknowns = kParameterCount + static_cast<std::size_t>(kMostZeros);

void linearize(const FitProblem &problem, const Fit &at, const FreeParameters &isFree, const Weights &weights,
               Linearized &result)
{
    // Of all five parameters; those that are held are left out at the end.
    std::array<double, kMostUnknowns *(kMostUnknowns + 1) / 2> sums{};
    std::array<double, kMostUnknowns> slopes{};
    double chiSquared = 0.0;
    InstantMotion motion;
    result.chiSquared = kInfinity;
    for (std::size_t row = 0; row < problem.time.size(); ++row) {
        if (!motion.compute(at.parameters, problem.time[row])) {
            return;
        }
        for (std::size_t k = 0; k < problem.columns.size(); ++k) {
            const FitColumn &column = problem.columns[k];
            const double value = column.values[row];
            if (std::isnan(value)) {
                continue;
            }
            const double zero = column.zero >= 0 ? at.zeros[static_cast<std::size_t>(column.zero)] : 0.0;
            const double difference = motion.valueOf(column.channel) + zero - value;
            const double residual = isTurning(column.channel) ? withoutTurns(difference) : difference;
            const double weight = weights[k][row];
            chiSquared += weight * residual * residual;
            const Gradient gradient = motion.gradientOf(column.channel);
            std::size_t next = 0;
            for (std::size_t i = 0; i < kParameterCount; ++i) {
                const double weighted = weight * gradient[static_cast<Eigen::Index>(i)];
                slopes[i] += weighted * residual;
                for (std::size_t j = 0; j <= i; ++j) {
                    sums[next++] += weighted * gradient[static_cast<Eigen::Index>(j)];
                }
            }
            if (column.zero >= 0) {
                const std::size_t i = kParameterCount + static_cast<std::size_t>(column.zero);
                slopes[i] += weight * residual;
                const std::size_t first = i * (i + 1) / 2;
                for (std::size_t j = 0; j < kParameterCount; ++j) {
                    sums[first + j] += weight * gradient[static_cast<Eigen::Index>(j)];
                }
                sums[first + i] += weight;
            }
        }
    }
    std::array<std::size_t, kMostUnknowns> kept{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < kParameterCount + static_cast<std::size_t>(problem.zeroCount); ++i) {
        if (i >= kParameterCount || isFree[i]) {
            kept[count++] = i;
        }
    }
    const auto n = static_cast<Eigen::Index>(count);
    result.matrix.resize(n, n);
    result.gradient.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const std::size_t row = kept[static_cast<std::size_t>(i)];
        result.gradient[i] = slopes[row];
        for (Eigen::Index j = 0; j <= i; ++j) {
            const double sum = sums[row * (row + 1) / 2 + kept[static_cast<std::size_t>(j)]];
            result.matrix(i, j) = sum;
            result.matrix(j, i) = sum;
        }
    }
    result.chiSquared = std::isfinite(chiSquared) ? chiSquared : kInfinity;
}

/// Levenberg-Marquardt with these weights.
void descend(const FitProblem &problem, Fit &at, const FreeParameters &isFree, const Weights &weights, int mostSteps,
             const std::stop_token &stop)
{
    constexpr double kRelativeGain = 1e-5;
    constexpr double kGain = 1e-4; // a hundredth of a standard error
    constexpr double kUndamped = 1e-13;
    bool isSettled = false;
    Linearized here;
    linearize(problem, at, isFree, weights, here);
    at.chiSquared = here.chiSquared;
    double damping = 1e-3;
    for (int i = 0; i < mostSteps && std::isfinite(at.chiSquared) && !stop.stop_requested(); ++i) {
        ++at.iterations;
        FitMatrix damped = here.matrix;
        const double floor = 1e-14 * here.matrix.diagonal().maxCoeff();
        for (Eigen::Index j = 0; j < damped.rows(); ++j) {
            damped(j, j) += damping * std::max(here.matrix(j, j), floor) + floor * 1e-6;
        }
        const FitVector step = -damped.ldlt().solve(here.gradient);
        Fit trial = at;
        if (step.allFinite()) {
            addStep(trial, isFree, problem.zeroCount, step);
        }
        Linearized there;
        if (step.allFinite() && trial.parameters.a > 0.0 && trial.parameters.b > 0.0) {
            linearize(problem, trial, isFree, weights, there);
        }
        if (there.chiSquared < at.chiSquared) {
            const double gain = at.chiSquared - there.chiSquared;
            trial.chiSquared = there.chiSquared;
            at = trial;
            here = there;
            damping *= 0.1;
            if (gain <= kRelativeGain * at.chiSquared + kGain) {
                // What is damped may only creep: it has to be so without, too.
                if (isSettled) {
                    break;
                }
                isSettled = true;
                damping = kUndamped;
            } else {
                isSettled = false;
            }
        } else if (isSettled) {
            break;
        } else {
            damping = std::max(1e-6, damping * (damping < 1e-4 ? 100.0 : 10.0));
            if (damping > 1e8) {
                break;
            }
        }
    }
}

/// The σ² that makes the mean of r²/(V + σ²) one; 0 where that of r²/V is within chance. V is of single values here:
/// that rows repeat makes them fewer, and none of them wider.
double noiseOf(const FitColumn &column, std::span<const double> residuals, std::span<const double> variance)
{
    const auto n = static_cast<double>(column.count);
    const double independent = n / column.repetition;
    const double repeated = 1.0 - 1.0 / column.repetition;
    const auto excess = [&](double noise, double *slope) {
        double sum = 0.0;
        double change = 0.0;
        for (std::size_t i = 0; i < residuals.size(); ++i) {
            if (!std::isnan(residuals[i])) {
                const double inverse = 1.0 / (variance[i] - repeated * column.variance[i] + noise);
                const double part = residuals[i] * residuals[i] * inverse;
                sum += part;
                change -= part * inverse;
            }
        }
        if (slope) {
            *slope = change / n;
        }
        return sum / n - 1.0;
    };
    if (excess(0.0, nullptr) <= 5.0 * std::sqrt(0.8 / independent) + 5.0 / independent) {
        return 0.0;
    }
    // Convex and falling: Newton from the left never passes the root, which is not below this.
    double squares = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        if (!std::isnan(residuals[i])) {
            squares += residuals[i] * residuals[i];
            most = std::max(most, variance[i]);
        }
    }
    double noise = std::max(squares / n - most, 0.0);
    for (int i = 0; i < 100; ++i) {
        double slope = 0.0;
        const double above = excess(noise, &slope);
        const double step = -above / slope;
        noise += step;
        if (!(step > 1e-4 * noise)) {
            break;
        }
    }
    return noise;
}

} // namespace

double arithmeticVariance(const FitProblem &problem, const FitColumn &column, double omega2)
{
    const double lost = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(omega2) * problem.farthest *
                        static_cast<double>(1 + static_cast<int>(column.channel.order)) * column.spread;
    return lost * lost;
}

bool isTurning(Channel channel)
{
    return isAngle(channel.coordinate) && channel.order == Order::Position;
}

double withoutTurns(double radians)
{
    return std::abs(radians) <= std::numbers::pi
               ? radians
               : radians - 2.0 * std::numbers::pi * std::round(radians / (2.0 * std::numbers::pi));
}

FileReading asWritten(const Observations &observations)
{
    FileReading reading;
    for (const ObservedColumn &column : observations.columns) {
        reading.push_back({column.channel});
    }
    return reading;
}

FitProblem problemOf(const Observations &observations, const FileReading &reading)
{
    FitProblem problem;
    problem.time = observations.time;
    problem.clockStep = observations.clockStep;
    problem.farthest = std::abs(observations.units.origin) / observations.units.second + 0.5;
    for (std::size_t i = 0; i < reading.size(); ++i) {
        const ObservedColumn &from = observations.columns[i];
        if (!reading[i].isUsed) {
            problem.leftOut += from.count;
            continue;
        }
        const double unit = observations.units.factor(reading[i].channel);
        const double factor = unit * reading[i].factor;
        FitColumn column;
        column.channel = reading[i].channel;
        column.source = i;
        column.count = from.count;
        column.repetition = from.repetition;
        column.spread = std::abs(factor) * from.spread;
        column.step = std::abs(factor) * from.step;
        column.values = from.values;
        for (double &value : column.values) {
            value = factor * value + unit * reading[i].turn;
        }
        column.variance = from.variance;
        for (double &variance : column.variance) {
            variance *= factor * factor;
        }
        if (reading[i].isZeroFree && problem.zeroCount < kMostZeros) {
            column.zero = problem.zeroCount++;
        }
        problem.valueCount += column.count;
        problem.columns.push_back(std::move(column));
    }
    return problem;
}

std::size_t freeCount(const FitProblem &problem, const FreeParameters &isFree)
{
    return static_cast<std::size_t>(std::ranges::count(isFree, true)) + static_cast<std::size_t>(problem.zeroCount);
}

bool residualsOf(const FitProblem &problem, const Fit &fit, FitResiduals &result)
{
    const std::size_t rows = problem.time.size();
    result.residuals.assign(problem.columns.size(), std::vector<double>(rows, kNone));
    result.variance.assign(problem.columns.size(), std::vector<double>(rows, kNone));
    InstantMotion motion;
    const bool hasRates = problem.clockStep > 0.0;
    std::vector<double> lost;
    for (const FitColumn &column : problem.columns) {
        lost.push_back(arithmeticVariance(problem, column, fit.parameters.omega2));
    }
    for (std::size_t row = 0; row < rows; ++row) {
        const double t = problem.time[row];
        if (!(hasRates ? motion.compute(fit.parameters, t) : motion.computeValues(fit.parameters, t))) {
            return false;
        }
        for (std::size_t k = 0; k < problem.columns.size(); ++k) {
            const FitColumn &column = problem.columns[k];
            if (std::isnan(column.values[row])) {
                continue;
            }
            const double zero = column.zero >= 0 ? fit.zeros[static_cast<std::size_t>(column.zero)] : 0.0;
            const double difference = column.values[row] - zero - motion.valueOf(column.channel);
            result.residuals[k][row] = isTurning(column.channel) ? withoutTurns(difference) : difference;
            double variance = column.variance[row] + lost[k];
            if (hasRates) {
                const double late = motion.rateOf(column.channel) * problem.clockStep;
                variance += late * late / 12.0;
            }
            result.variance[k][row] = variance;
        }
    }
    return true;
}

Fit fit(const FitProblem &problem, const Parameters &start, const FreeParameters &isFree, int mostRounds,
        const std::stop_token &stop)
{
    constexpr int kFirstSteps = 8;
    constexpr int kSteps = 25;
    constexpr double kSame = 0.01; // of a noise, between two rounds
    Fit result;
    result.parameters = start;
    // The constants are linear: at the start they are what the columns lie apart.
    FitResiduals apart;
    if (!residualsOf(problem, result, apart)) {
        return result;
    }
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        const FitColumn &column = problem.columns[k];
        if (column.zero >= 0) {
            double sum = 0.0;
            for (const double residual : apart.residuals[k]) {
                sum += std::isnan(residual) ? 0.0 : residual;
            }
            result.zeros[static_cast<std::size_t>(column.zero)] = sum / static_cast<double>(column.count);
        }
    }
    result.noise.assign(problem.columns.size(), 0.0);
    Weights weights;
    for (int round = 0; round < mostRounds && !stop.stop_requested(); ++round) {
        if (!residualsOf(problem, result, apart)) {
            result.chiSquared = kInfinity;
            return result;
        }
        weights = apart.variance;
        bool isSame = round > 0;
        for (std::size_t k = 0; k < problem.columns.size(); ++k) {
            const double noise = noiseOf(problem.columns[k], apart.residuals[k], apart.variance[k]);
            isSame = isSame && std::abs(noise - result.noise[k]) <= kSame * noise;
            result.noise[k] = noise;
            for (double &weight : weights[k]) {
                weight = 1.0 / (weight + noise);
            }
        }
        if (isSame) {
            break; // the same weights have the same minimum
        }
        if (freeCount(problem, isFree) > 0) {
            descend(problem, result, isFree, weights, round == 0 ? kFirstSteps : kSteps, stop);
        } else {
            result.chiSquared = 0.0; // nothing to fit
        }
        if (!result.exists()) {
            break;
        }
    }
    if (!result.exists() || !residualsOf(problem, result, apart)) {
        result.chiSquared = kInfinity;
        return result;
    }
    result.chiSquared = 0.0;
    double logarithms = 0.0;
    double constants = 0.0;
    const double perUnknown = std::log(static_cast<double>(problem.valueCount + problem.leftOut));
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        result.noise[k] = noiseOf(problem.columns[k], apart.residuals[k], apart.variance[k]);
        const double square = problem.columns[k].spread * problem.columns[k].spread;
        double information = 0.0; // of a free constant
        for (std::size_t row = 0; row < problem.time.size(); ++row) {
            const double residual = apart.residuals[k][row];
            if (!std::isnan(residual)) {
                const double variance = apart.variance[k][row] + result.noise[k];
                result.chiSquared += residual * residual / variance;
                logarithms += std::log(variance / square);
                information += 1.0 / variance;
            }
        }
        if (problem.columns[k].zero >= 0) {
            // Anything up to about the crank's length, or a radian, might have been.
            const double size = isAngle(problem.columns[k].channel.coordinate) ? 1.0 : result.parameters.a;
            constants += std::max(std::log(size * size * information), perUnknown);
        }
    }
    const double parameters = static_cast<double>(std::ranges::count(isFree, true));
    result.deviance = result.chiSquared + logarithms + static_cast<double>(problem.leftOut);
    result.score = result.deviance + parameters * perUnknown + constants;
    return result;
}

ExactFitMatrix informationOf(const FitProblem &problem, const Fit &fit, const FreeParameters &isFree)
{
    const auto unknowns = static_cast<Eigen::Index>(freeCount(problem, isFree));
    ExactFitMatrix information = ExactFitMatrix::Zero(unknowns, unknowns);
    Eigen::Matrix<long double, Eigen::Dynamic, 1> slope(unknowns);
    InstantMotion motion;
    for (std::size_t row = 0; row < problem.time.size(); ++row) {
        if (!motion.compute(fit.parameters, problem.time[row])) {
            continue;
        }
        for (std::size_t k = 0; k < problem.columns.size(); ++k) {
            const FitColumn &column = problem.columns[k];
            if (std::isnan(column.values[row])) {
                continue;
            }
            double variance =
                column.variance[row] + fit.noise[k] + arithmeticVariance(problem, column, fit.parameters.omega2);
            if (problem.clockStep > 0.0) {
                const double late = motion.rateOf(column.channel) * problem.clockStep;
                variance += late * late / 12.0;
            }
            const Gradient gradient = motion.gradientOf(column.channel);
            slope.setZero();
            Eigen::Index next = 0;
            for (std::size_t i = 0; i < kParameterCount; ++i) {
                if (isFree[i]) {
                    slope[next++] = gradient[static_cast<Eigen::Index>(i)];
                }
            }
            if (column.zero >= 0) {
                slope[next + column.zero] = 1.0;
            }
            information.noalias() += (slope / static_cast<long double>(variance)) * slope.transpose();
        }
    }
    return information;
}

double chiSquaredAt(const FitProblem &problem, const Fit &fit, const FreeParameters &isFree, const FitVector &step)
{
    FitResiduals apart;
    if (!residualsOf(problem, fit, apart)) {
        return kInfinity;
    }
    const std::vector<std::vector<double>> variance = std::move(apart.variance);
    Fit moved = fit;
    addStep(moved, isFree, problem.zeroCount, step);
    if (!(moved.parameters.a > 0.0) || !(moved.parameters.b > 0.0) || !residualsOf(problem, moved, apart)) {
        return kInfinity;
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        for (std::size_t row = 0; row < problem.time.size(); ++row) {
            const double residual = apart.residuals[k][row];
            if (!std::isnan(residual)) {
                sum += residual * residual / (variance[k][row] + fit.noise[k]);
            }
        }
    }
    return sum;
}

} // namespace slidercrank
