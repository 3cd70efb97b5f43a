// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion_fit.h"

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
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            x[i] = valueOf(m_start, m_free[static_cast<std::size_t>(i)]);
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
    Eigen::Matrix<double, Eigen::Dynamic, kParameterCount> m_derivatives;
};

} // namespace

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

double misfitAtBestSize(const Observations &observations, Parameters &parameters)
{
    // Of the channels that are lengths, weighted: model², model · value, value².
    double modelled = 0.0;
    double both = 0.0;
    double observed = 0.0;
    double squares = 0.0; // of the residuals of the others
    double count = 0.0;
    PlottedValues model;
    for (std::size_t row = 0; row < observations.time.size(); ++row) {
        if (!plottedMotion(parameters, observations.time[row], model)) {
            model.setZero();
        }
        for (const ObservedChannel &channel : observations.channels) {
            const double weight = channel.weights[row];
            if (kPlottedChannels[static_cast<std::size_t>(channel.plotted)].coordinate == R4x) {
                const double weightedModel = weight * model[channel.plotted];
                const double weightedValue = weight * channel.values[row];
                modelled += weightedModel * weightedModel;
                both += weightedModel * weightedValue;
                observed += weightedValue * weightedValue;
            } else {
                const double residual = weight * residualOf(channel, row, model);
                squares += residual * residual;
            }
            count += weight > 0.0 ? 1.0 : 0.0;
        }
    }
    const double scale = modelled > 0.0 && both > 0.0 ? both / modelled : 1.0;
    parameters.a *= scale;
    parameters.b *= scale;
    parameters.c *= scale;
    squares += observed + scale * (scale * modelled - 2.0 * both);
    return std::sqrt(std::max(squares, 0.0) / count);
}

bool linearize(const Observations &observations, const Parameters &parameters, Eigen::VectorXd &residuals,
               Eigen::Matrix<double, Eigen::Dynamic, kParameterCount> *derivatives)
{
    const std::size_t rows = observations.time.size();
    const auto count = static_cast<Eigen::Index>(rows * observations.channels.size());
    residuals.resize(count);
    if (derivatives) {
        derivatives->resize(count, kParameterCount);
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
    result.rms = method.fnorm / std::sqrt(static_cast<double>(valueCount(observations)));
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
    const std::span<const std::size_t> rows = supply.rows;
    for (std::size_t count = rowsBefore(rows, end).size(); count < rows.size() || iterations == 0;) {
        count = std::min(kGrowth * count, rows.size());
        const std::size_t most = count == rows.size() ? kMostFitRows : kRowsOnTheWay;
        const Observations more = lowestOrders(observe(data, units, thinned(rows.first(count), most)));
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
