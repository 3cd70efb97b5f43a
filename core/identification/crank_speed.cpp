// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/crank_speed.h"

#include "core/mechanism/turn.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

/// (time, θ2) of the rows that have it.
using CrankCourse = std::vector<std::pair<double, double>>;

const ObservedColumn *findColumn(const Observations &data, Channel channel)
{
    const auto column = std::ranges::find(data.columns, channel, &ObservedColumn::channel);
    return column == data.columns.end() ? nullptr : &*column;
}

/// Sum of n ln(unexplained part) over the columns, each fitted by a constant and two harmonics of ω.
double harmonicMisfit(const Observations &data, double omega)
{
    constexpr double kRegularization = 1e-9;
    constexpr double kLeastPart = 1e-5; // a slider-crank has more than two harmonics
    using Matrix = Eigen::Matrix<double, 5, 5>;
    using Vector = Eigen::Matrix<double, 5, 1>;
    std::vector<Vector> basis(data.abscissa.size());
    for (std::size_t i = 0; i < basis.size(); ++i) {
        const double c = std::cos(omega * data.abscissa[i]);
        const double s = std::sin(omega * data.abscissa[i]);
        basis[i] << 1.0, c, s, c * c - s * s, 2.0 * s * c;
    }
    double sum = 0.0;
    for (const ObservedColumn &column : data.columns) {
        if (!tellsShape(column)) {
            continue;
        }
        Matrix matrix = Matrix::Zero();
        Vector right = Vector::Zero();
        for (std::size_t i = 0; i < basis.size(); ++i) {
            if (!std::isnan(column.values[i])) {
                matrix.noalias() += basis[i] * basis[i].transpose();
                right += basis[i] * (column.values[i] - column.mean);
            }
        }
        matrix.diagonal().array() += kRegularization * column.count;
        const double all = column.count * column.spread * column.spread;
        const double left = 1.0 - right.dot(matrix.ldlt().solve(right)) / all;
        sum += column.count * std::log(std::max(left, 0.0) + kLeastPart);
    }
    return sum;
}

/// How often a column crosses its mean, beyond small wiggles; the largest of all columns.
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

/// θ2 without jumps that a speed of about `speed` explains.
CrankCourse crankCourse(const Observations &data, double speed)
{
    CrankCourse course;
    const ObservedColumn *const column = findColumn(data, {Theta2, Order::Position});
    for (std::size_t i = 0; column && i < data.abscissa.size(); ++i) {
        double angle = column->values[i];
        if (std::isnan(angle)) {
            continue;
        }
        if (!course.empty() && speed != 0.0) {
            const double expected = course.back().second + speed * (data.abscissa[i] - course.back().first);
            angle += kTurn * std::round((expected - angle) / kTurn);
        }
        course.emplace_back(data.abscissa[i], angle);
    }
    return course;
}

/// Coefficients of the polynomial through some points in least squares, about the first of them, and their standard
/// errors for values of that standard error.
template <int kTerms>
struct Polynomial {
    Eigen::Matrix<double, kTerms, 1> coefficients;
    Eigen::Matrix<double, kTerms, 1> standardErrors;
};

template <int kTerms, class Iterator>
Polynomial<kTerms> fitPolynomial(Iterator first, Iterator end, double standardError)
{
    using Matrix = Eigen::Matrix<double, kTerms, kTerms>;
    Matrix matrix = Matrix::Zero();
    Eigen::Matrix<double, kTerms, 1> right = right.Zero(), basis;
    const auto [t0, y0] = *first;
    for (; first != end; ++first) {
        for (int k = 0; k < kTerms; ++k) {
            basis[k] = std::pow(first->first - t0, k);
        }
        matrix += basis * basis.transpose();
        right += basis * (first->second - y0);
    }
    const Eigen::LDLT<Matrix> solver(matrix);
    const Matrix inverse = solver.solve(Matrix::Identity());
    return {solver.solve(right), standardError * inverse.diagonal().cwiseMax(0.0).cwiseSqrt()};
}

/// 0 where the file says nothing of it.
double givenCrankSpeed(const Observations &data)
{
    const ObservedColumn *const speedColumn = findColumn(data, {Theta2, Order::Velocity});
    const double speed = speedColumn ? speedColumn->mean : 0.0;
    const CrankCourse course = crankCourse(data, speed);
    return course.size() < 2 ? speed : fitPolynomial<2>(course.begin(), course.end(), 0.0).coefficients[1];
}

/// The minima of the periodogram, the lowest first, refined by bisection of the steps.
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
        return {{1.0, kDegreesPerRadian, 1.0 / kDegreesPerRadian}, {}, true}; // in the unit of the heading, or another
    }
    if (const double known = givenCrankSpeed(data); known != 0.0) {
        return {{std::abs(known)}, {}, true};
    }
    constexpr double kLeastTurns = 0.7;
    constexpr double kMostCrossingsOfArc = 6.0;
    const double crossings = meanCrossings(data);
    const double span = data.span();
    // Half of the rows' frequency, and not much more than the columns cross their means.
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
    const CrankCourse course = speed == 0.0 ? CrankCourse() : crankCourse(data, speed);
    if (course.size() < kFewestRows) {
        return std::nullopt;
    }
    const ObservedColumn &column = *findColumn(data, {Theta2, Order::Position});
    const double step = std::abs(speed) * data.printedStep + column.step;
    const Eigen::Vector2d line = fitPolynomial<2>(course.begin(), course.end(), 0.0).coefficients;
    double squares = 0.0;
    double products = 0.0;
    double before = 0.0;
    double largest = 0.0;
    for (const auto &[t, angle] : course) {
        const double residual = angle - course.front().second - line[0] - line[1] * (t - course.front().first);
        squares += residual * residual;
        products += residual * before;
        before = residual;
        largest = std::max(largest, std::abs(residual));
    }
    const auto n = static_cast<double>(course.size());
    if (largest <= 2.0 * step + 1e-4 || products <= 3.0 / std::sqrt(n) * squares) { // rounding, or white noise
        return std::nullopt;
    }
    const double interval = data.span() / (n - 1.0);
    std::ptrdiff_t part = 4; // as few rows as tell the speed to a hundredth, a tenth of them at most
    while (static_cast<double>(part) < n / 10.0 &&
           4.0 * step / (std::pow(static_cast<double>(part), 1.5) * interval) > 0.01 * std::abs(speed)) {
        ++part;
    }
    const Polynomial<3> start = fitPolynomial<3>(course.begin(), course.begin() + part, step / std::sqrt(12.0));
    const Polynomial<3> end = fitPolynomial<3>(course.rbegin(), course.rbegin() + part, step / std::sqrt(12.0));
    const CrankSpeedChange change{start.coefficients[1], end.coefficients[1]};
    const double error = std::hypot(start.standardErrors[1], end.standardErrors[1]);
    const double least = std::max(kErrors * error, kLeastPart * std::abs(speed));
    return std::abs(change.atEnd - change.atStart) > least ? std::optional(change) : std::nullopt;
}

} // namespace slidercrank
