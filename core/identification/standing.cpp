// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/standing.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace slidercrank
{

namespace
{

constexpr std::size_t kFewestNoisyRows = 20;

/// What a column's noise is held against: how much it varies, or would if it were not constant by nature.
double sizeOf(const FitColumn &column, const Parameters &p)
{
    const double rate = std::pow(std::abs(p.omega2), static_cast<int>(column.channel.order));
    const double constant = column.channel.coordinate == R4y ? p.a * rate
                            : column.channel.coordinate == Theta2 && column.channel.order != Order::Position ? rate
                                                                                                             : 0.0;
    return std::max(column.spread, constant);
}

/// Whether a number of steps has three digits or more, zeros at its end left out.
bool hasManyDigits(double steps)
{
    constexpr double kThreeDigits = 100.0;
    constexpr double kMost = 1e15;
    double whole = std::round(steps);
    while (whole >= kThreeDigits && whole < kMost && std::fmod(whole, 10.0) == 0.0) {
        whole /= 10.0;
    }
    return std::isfinite(steps) && whole >= kThreeDigits;
}

/// Whether harmonics of the crank's angle explain more than chance would.
bool isPeriodic(const std::vector<double> &values, const std::vector<double> &angles)
{
    const int harmonics = std::clamp(static_cast<int>(values.size()) / 6, 1, 8);
    const int terms = 1 + 2 * harmonics;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(terms, terms);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(terms);
    Eigen::VectorXd basis(terms);
    for (std::size_t i = 0; i < values.size(); ++i) {
        basis[0] = 1.0;
        for (int h = 1; h <= harmonics; ++h) {
            basis[2 * h - 1] = std::cos(h * angles[i]);
            basis[2 * h] = std::sin(h * angles[i]);
        }
        sums += basis * basis.transpose();
        right += values[i] * basis;
    }
    sums.diagonal().array() += 1e-9 * static_cast<double>(values.size());
    const double explained = right.dot(sums.ldlt().solve(right));
    return explained > terms + 4.0 * std::sqrt(2.0 * terms);
}

} // namespace

double correlationOf(const std::vector<double> &values)
{
    double squares = 0.0;
    double products = 0.0;
    double last = 0.0;
    for (const double value : values) {
        if (!std::isnan(value)) {
            squares += value * value;
            products += value * last;
            last = value;
        }
    }
    return squares > 0.0 ? products / squares : 0.0;
}

double distanceOf(const FitProblem &problem, const Fit &fit)
{
    double sum = static_cast<double>(problem.leftOut);
    double count = sum;
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        const FitColumn &column = problem.columns[k];
        if (isPlotted(column.channel) && column.spread > 0.0) {
            const double part = fit.exists() ? fit.noise[k] / (column.spread * column.spread) : 1.0;
            sum += static_cast<double>(column.count) * std::min(part, 1.0);
            count += static_cast<double>(column.count);
        }
    }
    return count > 0.0 ? sum / count : 1.0;
}

Standing standingOf(const FitProblem &problem, const Fit &fit)
{
    Standing standing;
    standing.stands = true;
    standing.isExact = true;
    standing.columnStands.assign(problem.columns.size(), true);
    FitResiduals left;
    if (!fit.exists() || !residualsOf(problem, fit, left)) {
        standing.stands = false;
        return standing;
    }
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        if (!(fit.noise[k] > 0.0)) {
            continue;
        }
        standing.isExact = false;
        std::vector<double> values;
        std::vector<double> angles;
        for (std::size_t row = 0; row < problem.time.size(); ++row) {
            if (!std::isnan(left.residuals[k][row])) {
                values.push_back(left.residuals[k][row] / std::sqrt(left.variance[k][row] + fit.noise[k]));
                const double turns =
                    (fit.parameters.omega2 * problem.time[row] + fit.parameters.theta20) / (2.0 * std::numbers::pi);
                angles.push_back(2.0 * std::numbers::pi * (turns - std::floor(turns)));
            }
        }
        const double deviation = std::sqrt(fit.noise[k]);
        const double part = deviation / sizeOf(problem.columns[k], fit.parameters);
        const double inTime = correlationOf(values);
        if (problem.columns[k].count < kFewestNoisyRows) {
            standing.columnStands[k] = false;
        } else if (part <= kIntegrationError) {
            const double rho = std::clamp(inTime, 0.0, 0.999);
            standing.inflation = std::max(standing.inflation, std::sqrt((1.0 + rho) / (1.0 - rho)));
        } else {
            std::vector<std::size_t> order(values.size());
            std::iota(order.begin(), order.end(), std::size_t{0});
            std::ranges::sort(order, {}, [&](std::size_t i) { return angles[i]; });
            std::vector<double> byAngle;
            for (const std::size_t i : order) {
                byAngle.push_back(values[i]);
            }
            const double most = 3.0 / std::sqrt(static_cast<double>(values.size()));
            standing.columnStands[k] =
                part <= kMostNoise && inTime <= most && correlationOf(byAngle) <= most && !isPeriodic(values, angles);
        }
        standing.stands = standing.stands && standing.columnStands[k];
    }
    return standing;
}

Uncertainty uncertaintyOf(const Observations &observations, const FitProblem &problem, const Fit &fit,
                          const FreeParameters &isFree, const Standing &standing)
{
    Uncertainty result;
    result.standardError.fill(kNone);
    const ExactFitMatrix information = informationOf(problem, fit, isFree);
    const Eigen::Index n = information.rows();
    Eigen::Matrix<long double, Eigen::Dynamic, 1> scale(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        scale[i] = information(i, i) > 0.0L ? 1.0L / std::sqrt(information(i, i)) : 1.0L;
    }
    const ExactFitMatrix scaled = scale.asDiagonal() * information * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<ExactFitMatrix> solver(scaled);
    constexpr long double kLeast = 1e-18L; // no more can be told from nothing
    const auto eigenvalues = solver.eigenvalues().cwiseMax(kLeast);
    result.conditionNumber = static_cast<double>(std::sqrt(eigenvalues[n - 1] / eigenvalues[0]));
    const ExactFitMatrix inverse =
        solver.eigenvectors() * eigenvalues.cwiseInverse().asDiagonal() * solver.eigenvectors().transpose();
    const ExactFitMatrix covariance = scale.asDiagonal() * inverse * scale.asDiagonal();

    const std::size_t unknowns = static_cast<std::size_t>(n);
    const double spare =
        static_cast<double>(problem.valueCount) - static_cast<double>(std::min(unknowns, problem.valueCount));
    const double factor = standing.inflation * (standing.isExact ? 1.0 : 1.0 + 2.0 / std::max(spare, 1.0));
    Eigen::Index next = 0;
    Eigen::Index speed = -1;
    Eigen::Index angle = -1;
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        if (isFree[i]) {
            speed = i == indexOf(Parameter::Omega2) ? next : speed;
            angle = i == indexOf(Parameter::Theta20) ? next : angle;
            result.standardError[i] = factor * static_cast<double>(std::sqrt(std::max(covariance(next, next), 0.0L)));
            ++next;
        }
    }
    // An even clock may still be a rounded one: a slope of at most a step over the whole time. Not where its interval
    // is a number that somebody chose: 0.005, 0.02.
    double clock = 0.0;
    if (observations.clockStep == 0.0 && isFree[indexOf(Parameter::Omega2)]) {
        const double span = observations.time.back() - observations.time.front();
        const double interval = span / std::max<double>(static_cast<double>(observations.time.size()) - 1.0, 1.0);
        clock = hasManyDigits(interval / observations.printedClockStep)
                    ? std::abs(fit.parameters.omega2) * observations.printedClockStep / (std::sqrt(12.0) * span)
                    : 0.0;
        double &ofSpeed = result.standardError[indexOf(Parameter::Omega2)];
        ofSpeed = std::hypot(ofSpeed, clock);
        double &ofAngle = result.standardError[indexOf(Parameter::Theta20)];
        ofAngle = std::hypot(ofAngle, clock);
    }
    if (speed >= 0 && angle >= 0) {
        const auto zero = static_cast<long double>(observations.units.origin / observations.units.second);
        const long double variance =
            covariance(angle, angle) - 2.0L * zero * covariance(angle, speed) + zero * zero * covariance(speed, speed);
        result.atClockZero = std::hypot(factor * static_cast<double>(std::sqrt(std::max(variance, 0.0L))),
                                        clock * (1.0 + static_cast<double>(std::abs(zero))));
    }

    // Straight: along each singular vector three standard errors cost nine.
    result.isStraight = true;
    for (Eigen::Index i = 0; i < n; ++i) {
        for (const double sign : {3.0, -3.0}) {
            FitVector step(n);
            for (Eigen::Index j = 0; j < n; ++j) {
                step[j] =
                    sign * static_cast<double>(scale[j] * solver.eigenvectors()(j, i) / std::sqrt(eigenvalues[i]));
            }
            constexpr double kNextToNothing = 1e-10; // what arithmetic leaves of a long run is not curvature
            if (step.cwiseAbs().maxCoeff() < kNextToNothing) {
                continue;
            }
            const double growth = chiSquaredAt(problem, fit, isFree, step) - fit.chiSquared;
            result.isStraight = result.isStraight && growth >= 4.5 && growth <= 18.0;
        }
    }

    double nats = 0.0;
    FitResiduals left;
    residualsOf(problem, fit, left);
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        const double spread = problem.columns[k].spread;
        for (std::size_t row = 0; row < problem.time.size(); ++row) {
            if (!std::isnan(left.residuals[k][row])) {
                const double variance = left.variance[k][row] + fit.noise[k];
                nats += std::log(spread / std::sqrt(2.0 * std::numbers::pi * std::numbers::e * variance));
            }
        }
    }
    result.evidence = spare / static_cast<double>(std::max<std::size_t>(problem.valueCount, 1)) * nats;
    return result;
}

} // namespace slidercrank
