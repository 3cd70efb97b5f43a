// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/crank_speed.h"

#include "core/identification/least_squares.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

const ObservedColumn *findColumn(const Observations &data, Channel channel)
{
    const auto column = std::ranges::find(data.columns, channel, &ObservedColumn::channel);
    return column == data.columns.end() ? nullptr : &*column;
}

/// The sum of n ln(unexplained part) over the columns, each of which is fitted by a constant and two harmonics of ω.
double harmonicMisfit(const Observations &data, double omega)
{
    constexpr double kLeastPart = 1e-5; // a slider-crank has more than two harmonics
    std::vector<double> angles;
    for (const double t : data.abscissa) {
        angles.push_back(omega * t);
    }
    const Eigen::MatrixXd basis = harmonicBasis(angles, 2);
    double sum = 0.0;
    for (const ObservedColumn &column : data.columns) {
        if (tellsShape(column)) {
            const double unexplained = 1.0 - explainedPart(basis, column.values, column.mean);
            sum += column.count * std::log(unexplained + kLeastPart);
        }
    }
    return sum;
}

/// The number of times that a column crosses its mean, not counting small oscillations; the largest of all columns.
double meanCrossings(const Observations &data)
{
    constexpr double kWiggle = 0.3; // of the spread
    double most = 0.0;
    for (const ObservedColumn &column : data.columns) {
        double count = 0.0;
        double side = 0.0;
        for (const double value : column.values) {
            if (tellsShape(column) && std::abs(value - column.mean) > kWiggle * column.spread) {
                count += side * (value - column.mean) < 0.0 ? 1.0 : 0.0;
                side = value > column.mean ? 1.0 : -1.0;
            }
        }
        most = std::max(most, count);
    }
    return most;
}

/// θ2 by time, continued by whole turns so that its speed is near `speed`; unchanged if that is 0.
std::vector<Point> crankAngleByTime(const Observations &data, double speed)
{
    std::vector<Point> points;
    const ObservedColumn *const column = findColumn(data, {Theta2, Order::Position});
    for (std::size_t i = 0; column && i < data.abscissa.size(); ++i) {
        Point point{data.abscissa[i], column->values[i]};
        if (std::isnan(point.y)) {
            continue;
        }
        if (!points.empty() && speed != 0.0) {
            const double expected = points.back().y + speed * (point.t - points.back().t);
            point.y += kTurn * std::round((expected - point.y) / kTurn);
        }
        points.push_back(point);
    }
    return points;
}

/// The mean speed of the crank by θ2 or its derivative; 0 if the file has neither.
double givenCrankSpeed(const Observations &data)
{
    const ObservedColumn *const speedColumn = findColumn(data, {Theta2, Order::Velocity});
    const double speed = speedColumn ? speedColumn->mean : 0.0;
    const std::vector<Point> points = crankAngleByTime(data, speed);
    return points.size() < 2 ? speed : fitPolynomial(points, 0.0, 2).coefficients[1];
}

/// The lowest minima of the periodogram, refined by bisection, from the lowest.
std::vector<double> periodogramMinima(const Observations &data, double low, double high, double step)
{
    constexpr std::size_t kMost = 4;
    constexpr double kFinest = 0.02; // of a step
    std::vector<double> speeds;
    std::vector<double> misfits;
    for (double speed = low; speed < high + step; speed += step) {
        speeds.push_back(speed);
        misfits.push_back(harmonicMisfit(data, speed));
    }
    std::vector<std::pair<double, double>> minima;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        if ((i > 0 && misfits[i] > misfits[i - 1]) || (i + 1 < speeds.size() && misfits[i] > misfits[i + 1])) {
            continue;
        }
        double speed = speeds[i];
        double misfit = misfits[i];
        for (double half = 0.5 * step; half > kFinest * step; half *= 0.5) {
            for (const double other : {speed - half, speed + half}) {
                if (const double tried = harmonicMisfit(data, other); tried < misfit) {
                    misfit = tried;
                    speed = other;
                    break;
                }
            }
        }
        minima.emplace_back(misfit, speed);
    }
    std::ranges::sort(minima);
    std::vector<double> best;
    for (std::size_t i = 0; i < std::min(minima.size(), kMost); ++i) {
        best.push_back(minima[i].second);
    }
    return best;
}

} // namespace

double roughTurns(const Observations &data)
{
    if (data.isByCrankAngle) {
        return data.span() / kTurn;
    }
    const double speed = givenCrankSpeed(data);
    return speed != 0.0 ? std::abs(speed) * data.span() / kTurn : 0.5 * meanCrossings(data) + 0.5;
}

SpeedCandidates speedCandidates(const Observations &data)
{
    if (data.isByCrankAngle) {
        return {{1.0, kDegreesPerRadian, 1.0 / kDegreesPerRadian},
                {},
                true}; // in the unit of the heading or in another one
    }
    if (const double known = givenCrankSpeed(data); known != 0.0) {
        return {{std::abs(known)}, {}, true};
    }
    constexpr double kLeastTurns = 0.7;
    constexpr double kMostCrossingsOfArc = 6.0;
    const double crossings = meanCrossings(data);
    const double span = data.span();
    // At most half of the sampling frequency, and little more than the number of mean crossings suggests.
    const double high =
        std::min(std::numbers::pi / data.interval() * 1.02, 1.2 * std::numbers::pi * (crossings + 3.0) / span);
    SpeedCandidates speeds{periodogramMinima(data, kLeastTurns * kTurn / span, high, 1.0 / span), {}, false};
    if (crossings <= kMostCrossingsOfArc) {
        for (double angle = 0.1; angle < 8.0; angle *= 1.25) {
            speeds.shortArc.push_back(angle / span);
        }
    }
    return speeds;
}

std::optional<CrankSpeedChange> crankSpeedChange(const Observations &data)
{
    constexpr std::size_t kFewestRows = 8;
    constexpr double kErrors = 4.0;     // standard errors between two speeds that differ
    constexpr double kLeastPart = 5e-3; // of the speed: less may be an error of the file's integrator or filter
    const double speed = data.isByCrankAngle ? 0.0 : givenCrankSpeed(data);
    const std::vector<Point> points = speed == 0.0 ? std::vector<Point>() : crankAngleByTime(data, speed);
    if (points.size() < kFewestRows) {
        return std::nullopt;
    }
    const ObservedColumn &column = *findColumn(data, {Theta2, Order::Position});
    const double step = std::abs(speed) * data.printedStep + column.step;
    const Eigen::VectorXd line = fitPolynomial(points, 0.0, 2).coefficients;
    double squares = 0.0;
    double products = 0.0;
    double before = 0.0;
    double largest = 0.0;
    for (const Point &point : points) {
        const double residual = point.y - line[0] - line[1] * point.t;
        squares += residual * residual;
        products += residual * before;
        before = residual;
        largest = std::max(largest, std::abs(residual));
    }
    const auto n = static_cast<double>(points.size());
    if (largest <= 2.0 * step + 1e-4 || products <= 3.0 / std::sqrt(n) * squares) { // rounding, or white noise
        return std::nullopt;
    }
    const double interval = data.span() / (n - 1.0);
    std::size_t rows = 4; // as few as determine the speed to 1 %, a tenth of all at most
    while (static_cast<double>(rows) < n / 10.0 &&
           4.0 * step / (std::pow(static_cast<double>(rows), 1.5) * interval) > 0.01 * std::abs(speed)) {
        ++rows;
    }
    const std::span<const Point> all = points;
    const Polynomial start = fitPolynomial(all.first(rows), all.front().t, 3);
    const Polynomial end = fitPolynomial(all.last(rows), all.back().t, 3);
    const CrankSpeedChange change{start.coefficients[1], end.coefficients[1]};
    const double error = step / std::sqrt(12.0) * std::hypot(start.standardErrors[1], end.standardErrors[1]);
    const double least = std::max(kErrors * error, kLeastPart * std::abs(speed));
    return std::abs(change.atEnd - change.atStart) > least ? std::optional(change) : std::nullopt;
}

} // namespace slidercrank
