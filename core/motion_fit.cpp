// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion_fit.h"

#include <unsupported/Eigen/NonLinearOptimization>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

/// Farther than any residual can be, so that a step to a mechanism that cannot move as the data do is taken back.
constexpr double kOutOfReach = 1e100;

/// A residual of θ3 without whole turns, which θ3 is known up to.
double angleDifference(double radians)
{
    return std::abs(radians) <= std::numbers::pi
               ? radians
               : radians - 2.0 * std::numbers::pi * std::round(radians / (2.0 * std::numbers::pi));
}

double residualOf(const ObservedChannel &channel, std::size_t row, const PlottedValues &model)
{
    const double difference = model[channel.plotted] - channel.values[row];
    return channel.plotted == 0 ? angleDifference(difference) : difference;
}

/// What Eigen's Levenberg-Marquardt asks for.
class Residuals
{
public:
    Residuals(const Observations &observations, const Parameters &start, const FreeParameters &isFree,
              std::stop_token stop)
        : m_observations(observations)
        , m_start(start)
        , m_stop(std::move(stop))
    {
        for (std::size_t i = 0; i < isFree.size(); ++i) {
            if (isFree[i]) {
                m_free.push_back(static_cast<Parameter>(i));
            }
        }
        m_count = static_cast<Eigen::Index>(observations.time.size() * observations.channels.size());
    }

    Eigen::VectorXd startingPoint() const
    {
        Eigen::VectorXd x(static_cast<Eigen::Index>(m_free.size()));
        Parameters parameters = m_start;
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            x[i] = valueOf(parameters, m_free[static_cast<std::size_t>(i)]);
        }
        return x;
    }

    Parameters parametersAt(const Eigen::VectorXd &x) const
    {
        Parameters parameters = m_start;
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            valueOf(parameters, m_free[static_cast<std::size_t>(i)]) = x[i];
        }
        return parameters;
    }

    Eigen::Index values() const { return m_count; }

    int operator()(const Eigen::VectorXd &x, Eigen::VectorXd &residuals)
    {
        if (m_stop.stop_requested()) {
            return -1;
        }
        if (!linearize(m_observations, parametersAt(x), residuals, nullptr)) {
            residuals.setConstant(m_count, kOutOfReach);
        }
        return 0;
    }

    int df(const Eigen::VectorXd &x, Eigen::MatrixXd &derivatives)
    {
        if (m_stop.stop_requested() || !linearize(m_observations, parametersAt(x), m_residuals, &m_derivatives)) {
            return -1;
        }
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            derivatives.col(i) = m_derivatives.col(static_cast<Eigen::Index>(m_free[static_cast<std::size_t>(i)]));
        }
        return 0;
    }

private:
    const Observations &m_observations;
    Parameters m_start;
    std::stop_token m_stop;
    std::vector<Parameter> m_free;
    Eigen::Index m_count = 0;
    Eigen::VectorXd m_residuals;
    Eigen::Matrix<double, Eigen::Dynamic, kParameterRows> m_derivatives;
};

} // namespace

double &valueOf(Parameters &parameters, Parameter which)
{
    switch (which) {
    case Parameter::A: return parameters.a;
    case Parameter::B: return parameters.b;
    case Parameter::C: return parameters.c;
    case Parameter::Omega2: return parameters.omega2;
    case Parameter::Theta20: break;
    }
    return parameters.theta20;
}

void weighByStep(Observations &observations, const Parameters &parameters)
{
    // A uniform distribution over one step has that variance.
    constexpr double kVarianceOfRounding = 1.0 / 12.0;
    // Residuals this much above what rounding leaves are no chance.
    constexpr double kTolerance = 2.0;

    std::vector<double> squares(observations.channels.size());
    std::vector<double> expected(observations.channels.size());
    std::vector<double> counts(observations.channels.size());
    PlottedValues model;
    for (std::size_t row = 0; row < observations.time.size(); ++row) {
        const bool moves = plottedMotion(parameters, observations.time[row], model);
        for (std::size_t k = 0; moves && k < observations.channels.size(); ++k) {
            const ObservedChannel &channel = observations.channels[k];
            if (channel.weights[row] > 0.0) {
                const double residual = residualOf(channel, row, model);
                squares[k] += residual * residual;
                expected[k] += kVarianceOfRounding * channel.steps[row] * channel.steps[row];
                counts[k] += 1.0;
            }
        }
    }
    for (std::size_t k = 0; k < observations.channels.size(); ++k) {
        ObservedChannel &channel = observations.channels[k];
        const double excess = squares[k] > kTolerance * kTolerance * expected[k]
                                  ? (squares[k] - expected[k]) / (kVarianceOfRounding * std::max(counts[k], 1.0))
                                  : 0.0;
        for (std::size_t row = 0; row < channel.weights.size(); ++row) {
            if (channel.weights[row] > 0.0) {
                channel.weights[row] = 1.0 / std::sqrt(channel.steps[row] * channel.steps[row] + excess);
            }
        }
    }
}

double misfit(const Observations &observations, const Parameters &parameters)
{
    PlottedValues model;
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t row = 0; row < observations.time.size(); ++row) {
        if (!plottedMotion(parameters, observations.time[row], model)) {
            model.setZero();
        }
        for (const ObservedChannel &channel : observations.channels) {
            const double residual = channel.weights[row] * residualOf(channel, row, model);
            squares += residual * residual;
            count += channel.weights[row] > 0.0 ? 1.0 : 0.0;
        }
    }
    return std::sqrt(squares / count);
}

void lengthenCoupler(const Observations &observations, Parameters &parameters)
{
    // So that the motion not only exists but has derivatives of ordinary size.
    constexpr double kSpare = 1e-3;
    double longest = 0.0;
    for (const double t : observations.time) {
        longest = std::max(
            longest, std::abs(parameters.c - parameters.a * std::sin(parameters.omega2 * t + parameters.theta20)));
    }
    if (!(std::abs(parameters.b) > longest)) {
        parameters.b = (1.0 + kSpare) * longest;
    }
}

bool linearize(const Observations &observations, const Parameters &parameters, Eigen::VectorXd &residuals,
               Eigen::Matrix<double, Eigen::Dynamic, kParameterRows> *derivatives)
{
    const std::size_t rows = observations.time.size();
    const auto count = static_cast<Eigen::Index>(rows * observations.channels.size());
    residuals.resize(count);
    if (derivatives) {
        derivatives->resize(count, kParameterRows);
    }
    PlottedValues model;
    PlottedDerivatives byParameter;
    for (std::size_t row = 0; row < rows; ++row) {
        const double t = observations.time[row];
        if (!(derivatives ? plottedMotion(parameters, t, model, byParameter) : plottedMotion(parameters, t, model))) {
            return false;
        }
        auto index = static_cast<Eigen::Index>(row);
        for (const ObservedChannel &channel : observations.channels) {
            const double weight = channel.weights[row];
            residuals[index] = weight * residualOf(channel, row, model);
            if (derivatives) {
                derivatives->row(index) = weight * byParameter.row(channel.plotted);
            }
            index += static_cast<Eigen::Index>(rows);
        }
    }
    return true;
}

Fit fit(const Observations &observations, const Parameters &start, const FreeParameters &isFree, int mostIterations,
        std::stop_token stop)
{
    using LevenbergMarquardt = Eigen::LevenbergMarquardt<Residuals>;
    Fit result;
    result.parameters = start;
    if (isFree[static_cast<std::size_t>(Parameter::B)]) {
        lengthenCoupler(observations, result.parameters);
    }
    Residuals residuals(observations, result.parameters, isFree, stop);
    Eigen::VectorXd x = residuals.startingPoint();
    LevenbergMarquardt method(residuals);
    // Beyond this the sum of squares changes by less than rounding does.
    method.parameters.ftol = 1e-12;
    method.parameters.xtol = 1e-12;
    // Parameters are near 1: the first step need not be longer than they are.
    method.parameters.factor = 1.0;
    if (method.minimizeInit(x) == Eigen::LevenbergMarquardtSpace::ImproperInputParameters ||
        method.fnorm >= kOutOfReach) {
        result.rms = std::numeric_limits<double>::infinity();
        return result;
    }
    auto status = Eigen::LevenbergMarquardtSpace::Running;
    while (status == Eigen::LevenbergMarquardtSpace::Running && result.iterations < mostIterations) {
        status = method.minimizeOneStep(x);
        ++result.iterations;
    }
    result.stopped = stop.stop_requested();
    result.parameters = residuals.parametersAt(x);
    double count = 0.0;
    for (const ObservedChannel &channel : observations.channels) {
        count += static_cast<double>(
            std::count_if(channel.weights.begin(), channel.weights.end(), [](double weight) { return weight > 0.0; }));
    }
    result.rms = method.fnorm / std::sqrt(count);
    return result;
}

Fit fitGrowing(const ReferenceData &data, const FitUnits &units, const Supply &supply, std::size_t end,
               const Parameters &start, const FreeParameters &isFree, std::stop_token stop)
{
    constexpr std::size_t kGrowth = 4;
    constexpr std::size_t kRowsOnTheWay = 256;
    constexpr int kMostIterations = 50;
    Fit result;
    result.parameters = start;
    int iterations = 0;
    for (std::size_t count = end - supply.firstRow; end < supply.endRow || iterations == 0;) {
        count *= kGrowth;
        end = std::min(supply.firstRow + count, supply.endRow);
        const std::size_t most = end == supply.endRow ? kMostFitRows : kRowsOnTheWay;
        const Observations more = lowestOrders(observe(data, units, spreadRows(supply.firstRow, end, most)));
        result = fit(more, result.parameters, isFree, kMostIterations, stop);
        iterations += result.iterations;
        if (result.stopped || !std::isfinite(result.rms)) {
            break;
        }
    }
    result.iterations = iterations;
    return result;
}

} // namespace slidercrank
