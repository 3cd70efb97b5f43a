// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification.h"

#include "core/motion_fit.h"
#include "core/motion_start.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slidercrank
{

namespace
{

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Rows that decide which start is the best.
constexpr std::size_t kScreeningRows = 64;

/// A fit whose residuals are larger than that, relative to how much the channels vary, resembles nothing.
constexpr double kResemblance = 0.1;

constexpr int kScreeningIterations = 30;
constexpr int kFinalIterations = 50;

/// Scales the lengths so that the channels that are lengths fit best.
void fitSize(const Observations &observations, Parameters &parameters)
{
    double modelled = 0.0;
    double observed = 0.0;
    PlottedValues model;
    for (std::size_t row = 0; row < observations.time.size(); ++row) {
        if (!plottedMotion(parameters, observations.time[row], model)) {
            continue;
        }
        for (const ObservedChannel &channel : observations.channels) {
            if (kPlottedChannels[static_cast<std::size_t>(channel.plotted)].coordinate == R4x) {
                const double weighted = channel.weights[row] * model[channel.plotted];
                modelled += weighted * weighted;
                observed += weighted * channel.weights[row] * channel.values[row];
            }
        }
    }
    const double scale = observed / modelled;
    if (scale > 0.0 && std::isfinite(scale)) {
        parameters.a *= scale;
        parameters.b *= scale;
        parameters.c *= scale;
    }
}

/// What rounding alone would leave as weighted residuals.
double roundingMisfit(const Observations &observations)
{
    double squares = 0.0;
    double count = 0.0;
    for (const ObservedChannel &channel : observations.channels) {
        for (std::size_t row = 0; row < channel.weights.size(); ++row) {
            const double part = channel.weights[row] * channel.steps[row];
            squares += part * part / 12.0;
            count += channel.weights[row] > 0.0 ? 1.0 : 0.0;
        }
    }
    return std::sqrt(squares / count);
}

/// The best of the starts after a fit to a few rows each; those that look best first, until one fits as well as
/// rounding lets it.
Fit screened(const Observations &observations, std::vector<Parameters> starts, bool sizeIsFree,
             const FreeParameters &isFree, const std::stop_token &stop)
{
    constexpr std::size_t kMostFits = 8;
    constexpr double kAsGoodAsRounding = 4.0;
    struct Ranked {
        double misfit;
        Parameters parameters;
    };
    std::vector<Ranked> ranked;
    for (Parameters &start : starts) {
        lengthenCoupler(observations, start);
        if (sizeIsFree) {
            fitSize(observations, start);
        }
        const double distance = misfit(observations, start);
        if (std::isfinite(distance)) {
            ranked.push_back({distance, start});
        }
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const Ranked &one, const Ranked &other) { return one.misfit < other.misfit; });
    ranked.resize(std::min(ranked.size(), kMostFits));

    Fit best;
    best.rms = std::numeric_limits<double>::infinity();
    const double enough = kAsGoodAsRounding * roundingMisfit(observations);
    for (const Ranked &start : ranked) {
        const Fit found = fit(observations, start.parameters, isFree, kScreeningIterations, stop);
        if (found.stopped) {
            return found;
        }
        if (found.rms < best.rms) {
            best = found;
        }
        if (best.rms <= enough) {
            break;
        }
    }
    return best;
}

/// Among mechanisms that move alike as far as the data tell, the one that turns as the start does.
Parameters likeStart(Parameters found, const Mechanism &start, const Supply &supply)
{
    if (supply.has(Theta3) && !supply.has({Theta3, Order::Position}) && !supply.has(R4x) &&
        found.branch != start.branch()) {
        found = {found.a, found.b, -found.c, found.omega2, found.theta20 + std::numbers::pi, start.branch()};
    }
    if (found.omega2 * start.omega2() < 0.0 && supply.has(Theta3) != supply.has(R4x)) {
        found.omega2 = -found.omega2;
        if (supply.has(R4x)) {
            found.c = -found.c;
            found.theta20 = -found.theta20;
        } else {
            found.theta20 = std::numbers::pi - found.theta20;
        }
    }
    return found;
}

/// Standard errors, condition number, and what is not fixed.
void judge(const Observations &observations, const Parameters &fitted, const FitUnits &units,
           const FreeParameters &isFree, std::size_t count, Identification &result)
{
    Eigen::VectorXd residuals;
    Eigen::Matrix<double, Eigen::Dynamic, kParameterRows> all;
    if (!linearize(observations, fitted, residuals, &all)) {
        return;
    }
    // θ20 is the angle at t = 0, not at the middle of the data.
    all.col(indexOf(Parameter::Omega2)) += units.origin / units.second * all.col(indexOf(Parameter::Theta20));
    const std::array<double, kParameterCount> unit{units.mm, units.mm, units.mm, 1.0 / units.second, 1.0};
    const std::array<double, kParameterCount> size{std::abs(fitted.a), std::abs(fitted.a), std::abs(fitted.a),
                                                   std::abs(fitted.omega2), 1.0};

    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        if (isFree[i]) {
            free.push_back(i);
        }
    }
    const auto n = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd scaled(all.rows(), n);
    Eigen::VectorXd norms(n);
    for (Eigen::Index j = 0; j < n; ++j) {
        const auto column = all.col(static_cast<Eigen::Index>(free[static_cast<std::size_t>(j)]));
        norms[j] = column.norm();
        scaled.col(j) = column / (norms[j] > 0.0 ? norms[j] : 1.0);
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(scaled);
    const Eigen::MatrixXd triangle = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(triangle, Eigen::ComputeFullV);
    const Eigen::VectorXd &singular = svd.singularValues();
    result.conditionNumber = singular[0] / singular[n - 1];

    const double freedom = std::max(static_cast<double>(count) - static_cast<double>(n), 1.0);
    const double variance = residuals.squaredNorm() / freedom;
    for (Eigen::Index j = 0; j < n; ++j) {
        const std::size_t i = free[static_cast<std::size_t>(j)];
        const double part = svd.matrixV().row(j).transpose().cwiseQuotient(singular).norm();
        const double error = std::sqrt(variance) * part / norms[j];
        result.identifiable[i] = error < size[i]; // also false for NaN
        if (result.identifiable[i]) {
            result.standardError[i] = error * unit[i];
        }
    }
}

/// Root mean square of the residuals in steps of the file's rounding.
double rmsInSteps(Observations observations, const Parameters &parameters)
{
    for (ObservedChannel &channel : observations.channels) {
        for (std::size_t row = 0; row < channel.weights.size(); ++row) {
            channel.weights[row] = channel.weights[row] > 0.0 ? 1.0 / channel.steps[row] : 0.0;
        }
    }
    return misfit(observations, parameters);
}

} // namespace

Identification identify(const ReferenceData &data, const Mechanism &start, std::stop_token stop)
{
    Identification result;
    result.parameters = start.parameters();
    result.standardError.fill(kNone);

    const Supply supply = supplyOf(data);
    const bool onlyAngles = !supply.has(R4x);
    FreeParameters isFree;
    isFree.fill(true);
    isFree[indexOf(Parameter::A)] = !onlyAngles;
    if (supply.values < (onlyAngles ? kParameterCount - 1 : kParameterCount) || supply.endRow < supply.firstRow + 2) {
        result.status = Identification::Status::TooFewData;
        return result;
    }
    const auto stopped = [&] {
        result.status = Identification::Status::Stopped;
        return result;
    };
    FitUnits units = unitsFor(data, supply, start.a());
    units.origin = 0.5 * (data.time[supply.firstRow] + data.time[supply.endRow - 1]);
    const Parameters given = units.toFit(start.parameters());

    // A few turns, a few rows; then all that there are.
    const Courses courses = coursesOf(data, supply, units);
    std::vector<Parameters> starts = startsFrom(courses, given.a);
    starts.push_back(given);
    if (stop.stop_requested()) {
        return stopped();
    }
    const Observations few =
        lowestOrders(observe(data, units, spreadRows(courses.firstRow, courses.endRow, kScreeningRows)));
    Fit found = screened(few, starts, !onlyAngles, isFree, stop);
    result.iterations = found.iterations;
    if (!found.stopped && std::isfinite(found.rms)) {
        found = fitGrowing(data, units, supply, courses.endRow, found.parameters, isFree, stop);
        result.iterations += found.iterations;
    }
    if (found.stopped) {
        return stopped();
    }
    const bool resembles = found.rms <= kResemblance;
    if (!std::isfinite(found.rms)) {
        return result;
    }

    found.parameters = likeStart(found.parameters, start, supply);
    Observations all = observe(data, units, spreadRows(supply.firstRow, supply.endRow, kMostFitRows));
    constexpr int kReweightings = 3;
    for (int i = 0; i < kReweightings; ++i) {
        weighByStep(all, found.parameters);
        const Parameters before = found.parameters;
        found = fit(all, found.parameters, isFree, kFinalIterations, stop);
        result.iterations += found.iterations;
        if (found.stopped) {
            return stopped();
        }
        if (found.parameters == before) {
            break;
        }
    }

    judge(all, found.parameters, units, isFree, supply.values, result);
    result.rms = rmsInSteps(all, found.parameters);
    result.parameters = units.fromFit(found.parameters);
    result.onlyRatios = onlyAngles;
    result.reversePossible = onlyAngles;
    result.otherBranchPossible = onlyAngles && !supply.has({Theta3, Order::Position});
    result.mirrorImagePossible = !supply.has(Theta3);
    if (onlyAngles) {
        for (const Parameter parameter : {Parameter::A, Parameter::B, Parameter::C}) {
            result.identifiable[indexOf(parameter)] = false;
            result.standardError[indexOf(parameter)] = kNone;
        }
    }
    result.status =
        resembles && !findFault(result.parameters) ? Identification::Status::Found : Identification::Status::NotFound;
    return result;
}

} // namespace slidercrank
