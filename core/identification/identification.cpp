// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/identification/motion_fit.h"
#include "core/identification/motion_start.h"
#include "core/mechanism/turn.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace slidercrank
{

namespace
{

/// Rows that decide which start is the best.
constexpr std::size_t kScreeningRows = 64;

/// A fit whose residuals are larger than that, relative to how much the channels vary, resembles nothing.
constexpr double kResemblance = 0.1;

/// Residuals up to so many times what rounding leaves may be rounding.
constexpr double kAsGoodAsRounding = 4.0;

/// A start from the data is good when its residuals are below that; otherwise others are tried.
constexpr double kGoodStart = 0.01;

/// Rows that the grid of starts is held against.
constexpr std::size_t kGridRows = 16;

constexpr int kScreeningIterations = 400;
constexpr int kFinalIterations = 50;

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
Fit screened(const Observations &observations, std::vector<Parameters> starts, const FreeParameters &isFree,
             const std::stop_token &stop)
{
    constexpr std::size_t kMostFits = 8;
    struct Ranked {
        double misfit;
        Parameters parameters;
    };
    std::vector<Ranked> ranked;
    for (Parameters &start : starts) {
        lengthenCoupler(observations, start);
        const double distance = misfitAtBestSize(observations, start);
        if (std::isfinite(distance)) {
            ranked.push_back({distance, start});
        }
    }
    std::ranges::stable_sort(ranked, {}, &Ranked::misfit);
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

/// What a fit is worth.
struct Accuracy {
    std::array<double, kParameterCount> standardError; ///< in FitUnits, of θ20 at t = 0; NaN where held
    double conditionNumber = 0.0;
};

Accuracy accuracyOf(const Observations &observations, const Parameters &fitted, const FitUnits &units,
                    const FreeParameters &isFree)
{
    Accuracy accuracy;
    accuracy.standardError.fill(kNone);
    Eigen::VectorXd residuals;
    Eigen::Matrix<double, Eigen::Dynamic, kParameterCount> all;
    if (!linearize(observations, fitted, residuals, &all)) {
        return accuracy;
    }
    // θ20 is the angle at t = 0, not at the middle of the data.
    all.col(indexOf(Parameter::Omega2)) += units.origin / units.second * all.col(indexOf(Parameter::Theta20));

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
    accuracy.conditionNumber = singular[0] / singular[n - 1];

    const double freedom = std::max(static_cast<double>(valueCount(observations)) - static_cast<double>(n), 1.0);
    const double deviation = std::max(std::sqrt(residuals.squaredNorm() / freedom), roundingMisfit(observations));
    for (Eigen::Index j = 0; j < n; ++j) {
        const double length = svd.matrixV().row(j).transpose().cwiseQuotient(singular).norm();
        accuracy.standardError[free[static_cast<std::size_t>(j)]] = deviation * length / norms[j];
    }
    return accuracy;
}

/// The parameters whose standard error is not less than the size of such a thing: the crank's length, the speed, a
/// radian.
FreeParameters undetermined(const Accuracy &accuracy, const Parameters &fitted, const FreeParameters &isFree)
{
    const double length = std::abs(fitted.a);
    const std::array<double, kParameterCount> sizes{length, length, length, std::abs(fitted.omega2), 1.0};
    FreeParameters result{};
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        result[i] = isFree[i] && !(accuracy.standardError[i] < sizes[i]); // also where it is NaN
    }
    return result;
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

/// Whether any channel varies by more than its rounding.
bool moves(const Observations &observations)
{
    return std::any_of(observations.channels.begin(), observations.channels.end(), [](const ObservedChannel &channel) {
        return channel.deviation > *std::max_element(channel.steps.begin(), channel.steps.end());
    });
}

/// The mechanism that fits a few rows of the first few turns best.
Fit fitToFew(const ReferenceData &data, const FitUnits &units, const Supply &supply, const Courses &courses,
             const Parameters &given, const FreeParameters &isFree, const std::stop_token &stop)
{
    const std::span<const std::size_t> rows = rowsBefore(supply.rows, courses.endRow);
    const Observations few = lowestOrders(observe(data, units, thinned(rows, kScreeningRows)));
    std::vector<Parameters> starts = startsFrom(courses, likelySpeeds(courses), given.a);
    starts.push_back(given);
    const Fit first = screened(few, starts, isFree, stop);
    if (first.stopped || first.rms <= kGoodStart) {
        return first;
    }
    starts = startsFrom(courses, allSpeeds(courses), given.a);
    if (starts.empty()) {
        // The sum of R̈4x may turn back four times a turn.
        std::vector<double> speeds = likelySpeeds(courses);
        for (std::size_t i = 0, count = speeds.size(); i < count; ++i) {
            speeds.push_back(0.5 * speeds[i]);
        }
        const Observations fewer = lowestOrders(observe(data, units, thinned(rows, kGridRows)));
        const bool bothDirections = supply.has(Theta3) && supply.has(R4x);
        starts = startsFromGrid(fewer, speeds, bothDirections, given.a, stop);
    }
    const Fit second = screened(few, starts, isFree, stop);
    return second.stopped || second.rms < first.rms ? second : first;
}

/// Fitted with each value's own weight, again after the weights have changed.
Fit fitByStep(Observations &observations, Fit found, const FreeParameters &isFree, const std::stop_token &stop)
{
    constexpr int kTimes = 3;
    int iterations = 0;
    for (int i = 0; i < kTimes && !found.stopped; ++i) {
        weighByStep(observations, found.parameters);
        const Parameters before = found.parameters;
        found = fit(observations, before, isFree, kFinalIterations, stop);
        iterations += found.iterations;
        if (found.parameters == before) {
            break;
        }
    }
    found.iterations = iterations;
    return found;
}

/// What the data leave open goes back to what it was, as far as they do: it is then no longer free.
void keepUndetermined(const Observations &observations, const FitUnits &units, const Parameters &given, Fit &found,
                      FreeParameters &isFree, const std::stop_token &stop)
{
    constexpr double kNoWorse = 1.05;
    const FreeParameters open =
        undetermined(accuracyOf(observations, found.parameters, units, isFree), found.parameters, isFree);
    if (open == FreeParameters{}) {
        return;
    }
    FreeParameters remaining = isFree;
    Parameters kept = found.parameters;
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        if (open[i]) {
            remaining[i] = false;
            valueOf(kept, static_cast<Parameter>(i)) = valueOf(given, static_cast<Parameter>(i));
        }
    }
    const Fit held = fit(observations, kept, remaining, kFinalIterations, stop);
    if (held.rms <= kNoWorse * found.rms) {
        found = held;
        isFree = remaining;
    }
}

/// With θ20 in [-π, π).
std::vector<Identification::Alternative> imagesNotExcluded(const Parameters &p, const Supply &supply)
{
    using Why = Identification::Alternative::Why;
    std::vector<Identification::Alternative> images;
    const auto add = [&](Why why, double c, double omega2, double theta20, Branch branch) {
        images.push_back({why, {p.a, p.b, c, omega2, wrapped(theta20), branch}});
    };
    if (!supply.has(Theta3)) {
        add(Why::MirrorImage, -p.c, -p.omega2, -p.theta20, p.branch);
    }
    if (!supply.has(R4x)) {
        add(Why::Reversed, p.c, -p.omega2, std::numbers::pi - p.theta20, p.branch);
        if (!supply.has({Theta3, Order::Position})) {
            add(Why::OtherAssembly, -p.c, p.omega2, p.theta20 + std::numbers::pi, otherThan(p.branch));
        }
    }
    return images;
}

} // namespace

Identification identify(const ReferenceData &data, const Mechanism &start, std::stop_token stop)
{
    using Outcome = Identification::Outcome;
    using Lack = Identification::Lack;
    Identification result;
    result.parameters = start.parameters();
    result.standardError.fill(kNone);
    const auto lacking = [&](Lack lack) {
        result.outcome = Outcome::Insufficient;
        result.lack = lack;
        return result;
    };

    const Supply supply = supplyOf(data);
    const bool onlyAngles = !supply.has(R4x);
    FreeParameters isFree;
    isFree.fill(true);
    isFree[indexOf(Parameter::A)] = !onlyAngles;
    if (supply.values < (onlyAngles ? kParameterCount - 1 : kParameterCount) || supply.rows.size() < 2) {
        return lacking(Lack::FewValues);
    }
    FitUnits units = unitsFor(data, supply, start.a());
    units.origin = 0.5 * (data.time[supply.rows.front()] + data.time[supply.rows.back()]);
    Observations all = observe(data, units, thinned(supply.rows, kMostFitRows));
    if (!moves(all)) {
        return lacking(Lack::NothingMoves);
    }
    const Parameters given = units.toFit(start.parameters());
    const Courses courses = coursesOf(data, supply, units);

    // A few rows of the first turns, more of them, all; then by each value's own weight.
    Fit found = fitToFew(data, units, supply, courses, given, isFree, stop);
    result.iterations = found.iterations;
    if (!found.stopped && std::isfinite(found.rms)) {
        found = fitGrowing(data, units, supply, courses.endRow, found.parameters, isFree, stop);
        result.iterations += found.iterations;
    }
    if (!found.stopped && !std::isfinite(found.rms)) {
        return result;
    }
    const bool resembles = found.rms <= std::max(kResemblance, kAsGoodAsRounding * roundingMisfit(lowestOrders(all)));
    found.parameters = likeStart(found.parameters, start, supply);
    found = fitByStep(all, found, isFree, stop);
    result.iterations += found.iterations;
    keepUndetermined(all, units, given, found, isFree, stop);
    if (stop.stop_requested()) {
        result.stopped = true;
        return result;
    }
    const Parameters parameters = units.fromFit(found.parameters);
    if (!resembles || findFault(parameters)) {
        return result;
    }

    const Accuracy accuracy = accuracyOf(all, found.parameters, units, isFree);
    const std::array<double, kParameterCount> unit{units.mm, units.mm, units.mm, 1.0 / units.second, 1.0};
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        result.standardError[i] = unit[i] * accuracy.standardError[i];
        const bool isLength = i <= indexOf(Parameter::C);
        result.identifiable[i] = std::isfinite(result.standardError[i]) && !(onlyAngles && isLength);
    }
    result.conditionNumber = accuracy.conditionNumber;
    result.rms = rmsInSteps(all, found.parameters);
    result.parameters = parameters;
    result.onlyRatios = onlyAngles;
    result.alternatives = imagesNotExcluded(parameters, supply);
    result.outcome = Outcome::Identified;
    return result;
}

} // namespace slidercrank
