// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/crank_speed.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace slidercrank
{

namespace
{

using std::numbers::pi;

/// All coordinates that a motion is seen in.
std::vector<Family> familiesOf(const FitProblem &problem)
{
    std::vector<Family> families;
    for (const Coordinate coordinate : {Theta3, R4x, R3x, R3y, R2x, R2y}) {
        if (Family family = familyOf(problem, coordinate); !family.columns.empty()) {
            families.push_back(std::move(family));
        }
    }
    return families;
}

double rootMeanSquare(const FitColumn &column, bool lessMean)
{
    double sum = 0.0;
    double squares = 0.0;
    for (const double value : column.values) {
        if (!std::isnan(value)) {
            sum += value;
            squares += value * value;
        }
    }
    const auto n = static_cast<double>(column.count);
    return std::sqrt(std::max(squares / n - (lessMean ? sum * sum / (n * n) : 0.0), 0.0));
}

/// Where f is least between the two.
double leastBetween(double low, double high, int steps, const std::function<double(double)> &f)
{
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    double x = high - golden * (high - low);
    double y = low + golden * (high - low);
    double fx = f(x);
    double fy = f(y);
    for (int i = 0; i < steps; ++i) {
        if (fx < fy) {
            high = y;
            y = x;
            fy = fx;
            x = high - golden * (high - low);
            fx = f(x);
        } else {
            low = x;
            x = y;
            fx = fy;
            y = low + golden * (high - low);
            fy = f(y);
        }
    }
    return fx < fy ? x : y;
}

std::vector<double> speedsByHarmonics(const FitProblem &problem, const std::vector<Family> &families,
                                      const std::stop_token &stop)
{
    constexpr double kFewestTurns = 0.7;
    constexpr double kStep = 1.2; // of W times the whole time
    constexpr std::size_t kMostMinima = 4;
    constexpr int kRefinements = 14;
    const auto rows = static_cast<double>(problem.time.size());
    double low = 2.0 * pi * kFewestTurns;
    double high = pi * rows;
    // rms of a derivative over rms of its function, about its mean, is at least the speed.
    double ratio = std::numeric_limits<double>::infinity();
    double largestRatio = 0.0;
    for (const Family &family : families) {
        for (std::size_t i = 0; i + 1 < family.columns.size(); ++i) {
            const FitColumn &function = *family.columns[i];
            const FitColumn &derivative = *family.columns[i + 1];
            if (static_cast<int>(derivative.channel.order) != static_cast<int>(function.channel.order) + 1) {
                continue;
            }
            const double one = rootMeanSquare(derivative, false) / rootMeanSquare(function, true);
            if (one > 0.0 && std::isfinite(one)) {
                ratio = std::min(ratio, one);
                largestRatio = std::max(largestRatio, one);
            }
        }
    }
    if (std::isfinite(ratio)) {
        constexpr double kFewRowsATurn = 5.0;
        const bool isSparse = 1.15 * ratio / (2.0 * pi) * kFewRowsATurn > rows;
        high = std::min((isSparse ? 3.0 : 1.15) * ratio, 10.0 * pi * rows);
        low = std::max(low, std::min(0.2 * largestRatio, 0.5 * high));
    }
    if (!(low < high)) {
        return {};
    }
    const auto leftAt = [&](const Phases &phases) {
        double left = 0.0;
        for (const Family &family : families) {
            left += stop.stop_requested() ? std::numeric_limits<double>::infinity()
                                          : leftBy(problem, family, phases, 2, nullptr);
        }
        return left;
    };
    std::vector<double> places;
    std::vector<double> values;
    const Phases step = phasesAt(problem, kStep);
    for (Phases phases = phasesAt(problem, low); phases.speed < high + kStep; advance(phases, step)) {
        places.push_back(phases.speed);
        values.push_back(leftAt(phases));
    }
    return minimaOver(places, values, kMostMinima, kRefinements,
                      [&](double speed) { return leftAt(phasesAt(problem, speed)); });
}

} // namespace

const FitColumn *columnOf(const FitProblem &problem, Channel channel)
{
    const auto found = std::ranges::find(problem.columns, channel, &FitColumn::channel);
    return found == problem.columns.end() ? nullptr : &*found;
}

Family familyOf(const FitProblem &problem, Coordinate coordinate)
{
    Family family;
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        if (const FitColumn *column = columnOf(problem, {coordinate, order}); column && column->spread > 0.0) {
            family.columns.push_back(column);
            family.hasPosition = family.hasPosition || order == Order::Position;
        }
    }
    return family;
}

Phases phasesAt(const FitProblem &problem, double speed)
{
    Phases phases{speed, {}, {}};
    for (const double t : problem.time) {
        phases.cosine.push_back(std::cos(speed * t));
        phases.sine.push_back(std::sin(speed * t));
    }
    return phases;
}

void advance(Phases &phases, const Phases &step)
{
    phases.speed += step.speed;
    for (std::size_t i = 0; i < phases.cosine.size(); ++i) {
        const double cosine = phases.cosine[i];
        phases.cosine[i] = cosine * step.cosine[i] - phases.sine[i] * step.sine[i];
        phases.sine[i] = phases.sine[i] * step.cosine[i] + cosine * step.sine[i];
    }
}

double leftBy(const FitProblem &problem, const Family &family, const Phases &phases, int harmonics, Series *series)
{
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostTerms, kMostTerms>;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostTerms, 1>;
    const Eigen::Index first = family.hasPosition ? 0 : 1;
    const Eigen::Index terms = 1 + 2 * harmonics - first;
    std::array<double, kMostTerms * kMostTerms> sums{};
    std::array<double, kMostTerms> right{};
    double squares = 0.0;
    double left = 0.0;
    for (std::size_t row = 0; row < problem.time.size(); ++row) {
        const double cosine = phases.cosine[row];
        const double sine = phases.sine[row];
        std::array<double, kMostTerms> basis{};
        std::array<double, kMostTerms> turned{};
        basis[0] = 1.0;
        basis[1] = cosine;
        basis[2] = sine;
        for (int h = 2; h <= harmonics; ++h) {
            const auto i = static_cast<std::size_t>(2 * h - 1);
            basis[i] = basis[i - 2] * cosine - basis[i - 1] * sine;
            basis[i + 1] = basis[i - 1] * cosine + basis[i - 2] * sine;
        }
        for (const FitColumn *column : family.columns) {
            const double value = column->values[row];
            if (std::isnan(value)) {
                continue;
            }
            const int order = static_cast<int>(column->channel.order);
            const double weight = 1.0 / column->spread;
            turned[0] = order == 0 ? weight : 0.0;
            for (int h = 1; h <= harmonics; ++h) {
                const auto i = static_cast<std::size_t>(2 * h - 1);
                const double rate = h * phases.speed;
                const double scale = weight * (order == 0 ? 1.0 : order == 1 ? rate : rate * rate);
                turned[i] = scale * (order == 0 ? basis[i] : order == 1 ? -basis[i + 1] : -basis[i]);
                turned[i + 1] = scale * (order == 0 ? basis[i + 1] : order == 1 ? basis[i] : -basis[i + 1]);
            }
            const double scaled = weight * value;
            squares += scaled * scaled;
            for (Eigen::Index i = first; i < 1 + 2 * harmonics; ++i) {
                const double one = turned[static_cast<std::size_t>(i)];
                right[static_cast<std::size_t>(i)] += one * scaled;
                double *const line = sums.data() + i * kMostTerms;
                for (Eigen::Index j = first; j <= i; ++j) {
                    line[j] += one * turned[static_cast<std::size_t>(j)];
                }
            }
        }
    }
    Matrix matrix(terms, terms);
    Vector vector(terms);
    for (Eigen::Index i = 0; i < terms; ++i) {
        vector[i] = right[static_cast<std::size_t>(i + first)];
        for (Eigen::Index j = 0; j <= i; ++j) {
            const double sum = sums[static_cast<std::size_t>((i + first) * kMostTerms + j + first)];
            matrix(i, j) = sum;
            matrix(j, i) = sum;
        }
    }
    // Over less than a turn the harmonics are nearly the same: no term may grow without bound.
    constexpr double kRidge = 1e-11;
    matrix.diagonal().array() += kRidge * matrix.diagonal().maxCoeff();
    const Vector solution = matrix.ldlt().solve(vector);
    left = squares - vector.dot(solution);
    if (series) {
        series->harmonics = harmonics;
        series->hasConstant = family.hasPosition;
        series->terms.setZero();
        series->terms.segment(first, terms) = solution;
    }
    return std::max(left, 0.0);
}

std::vector<double> minimaOver(const std::vector<double> &places, const std::vector<double> &values, std::size_t most,
                               int steps, const std::function<double(double)> &f)
{
    std::vector<std::size_t> minima;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if ((i == 0 || values[i] <= values[i - 1]) && (i + 1 == places.size() || values[i] <= values[i + 1]) &&
            std::isfinite(values[i])) {
            minima.push_back(i);
        }
    }
    std::ranges::sort(minima, {}, [&](std::size_t i) { return values[i]; });
    minima.resize(std::min(minima.size(), most));
    std::vector<double> found;
    for (const std::size_t i : minima) {
        const double low = places[i == 0 ? i : i - 1];
        const double high = places[std::min(i + 1, places.size() - 1)];
        found.push_back(leastBetween(low, high, steps, f));
    }
    return found;
}

double crankSpeedOf(const FitProblem &problem)
{
    double speed = 0.0;
    const FitColumn *rate = columnOf(problem, {Theta2, Order::Velocity});
    if (rate) {
        double sum = 0.0;
        for (const double value : rate->values) {
            sum += std::isnan(value) ? 0.0 : value;
        }
        speed = sum / static_cast<double>(rate->count);
    }
    const FitColumn *angle = columnOf(problem, {Theta2, Order::Position});
    if (!angle || angle->count < 2) {
        return speed;
    }
    // Made continuous: by the known rate, or, where it goes on in one direction anyway, not at all.
    std::vector<double> times;
    std::vector<double> angles;
    for (std::size_t i = 0; i < problem.time.size(); ++i) {
        if (!std::isnan(angle->values[i])) {
            times.push_back(problem.time[i]);
            angles.push_back(angle->values[i]);
        }
    }
    const bool isMonotonic = std::ranges::is_sorted(angles) || std::ranges::is_sorted(angles, std::ranges::greater());
    for (std::size_t i = 1; i < angles.size() && (!isMonotonic || rate); ++i) {
        const double expected = rate ? speed * (times[i] - times[i - 1]) : 0.0;
        angles[i] = angles[i - 1] + expected + withoutTurns(angles[i] - angles[i - 1] - expected);
    }
    const double n = static_cast<double>(times.size());
    const double meanTime = std::accumulate(times.begin(), times.end(), 0.0) / n;
    const double meanAngle = std::accumulate(angles.begin(), angles.end(), 0.0) / n;
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        products += (times[i] - meanTime) * (angles[i] - meanAngle);
        squares += (times[i] - meanTime) * (times[i] - meanTime);
    }
    return squares > 0.0 ? products / squares : speed;
}

std::vector<double> speedsOf(const FitProblem &problem, const std::stop_token &stop)
{
    const double speed = crankSpeedOf(problem);
    return speed != 0.0 ? std::vector<double>{std::abs(speed)} : speedsByHarmonics(problem, familiesOf(problem), stop);
}

} // namespace slidercrank
