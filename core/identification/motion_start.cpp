// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion_start.h"

#include "core/identification/crank_speed.h"
#include "core/identification/linear_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace slidercrank
{

namespace
{

using std::numbers::pi;
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// From six harmonics, at the phases of one turn.
Positions positionsOverATurn(const FitProblem &problem, double speed)
{
    constexpr int kPhases = 48;
    const Phases phases = phasesAt(problem, speed);
    const auto seriesOf = [&](Coordinate coordinate) {
        std::optional<Series> series;
        if (const Family family = familyOf(problem, coordinate); !family.columns.empty()) {
            std::size_t values = 0;
            for (const FitColumn *column : family.columns) {
                values += column->count;
            }
            const int harmonics = std::clamp((static_cast<int>(values) - 3) / 2, 1, kMostHarmonics);
            leftBy(problem, family, phases, harmonics, &series.emplace());
        }
        return series;
    };
    const std::optional<Series> theta3 = seriesOf(Theta3);
    const std::optional<Series> slider = seriesOf(R4x);
    std::optional<Series> coupler;
    std::optional<Series> pin; // half of A, or the same a quarter of a turn later
    bool isQuarterLate = false;
    if (!slider) {
        coupler = seriesOf(R3x);
        pin = seriesOf(R2x);
        if (coupler && !pin) {
            isQuarterLate = true;
            pin = seriesOf(R2y);
            pin = pin ? pin : seriesOf(R3y);
        }
    }
    Positions positions;
    for (int i = 0; i < kPhases; ++i) {
        const double phase = 2.0 * pi * i / kPhases;
        positions.phase.push_back(phase);
        if (theta3) {
            positions.theta3.push_back(theta3->at(phase));
            positions.isTheta3Whole = theta3->hasConstant;
        }
        if (slider) {
            positions.R4x.push_back(slider->at(phase));
            positions.isR4xWhole = slider->hasConstant;
        } else if (coupler && pin) {
            // sin θ2 a quarter of a turn later is cos θ2.
            const double half = pin->fundamentalAt(phase, isQuarterLate ? 0.5 * pi : 0.0);
            positions.R4x.push_back(2.0 * (coupler->at(phase) - half));
            positions.isR4xWhole = coupler->hasConstant;
        }
    }
    return positions;
}

/// A coordinate on the rows, a derivative summed up by the trapezoidal rule; empty where there are accelerations only.
std::vector<double> courseOf(const FitProblem &problem, Coordinate coordinate, bool &isWhole)
{
    if (const FitColumn *position = columnOf(problem, {coordinate, Order::Position})) {
        isWhole = true;
        return position->values;
    }
    const FitColumn *velocity = columnOf(problem, {coordinate, Order::Velocity});
    isWhole = false;
    if (!velocity) {
        return {};
    }
    std::vector<double> sums(velocity->values.size(), kNone);
    double sum = 0.0;
    double lastTime = kNone;
    double lastValue = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (std::isnan(velocity->values[i])) {
            continue;
        }
        if (std::isfinite(lastTime)) {
            sum += 0.5 * (velocity->values[i] + lastValue) * (problem.time[i] - lastTime);
        }
        sums[i] = sum;
        lastTime = problem.time[i];
        lastValue = velocity->values[i];
    }
    return sums;
}

/// The rows themselves, few enough; `phase` holds the times.
Positions positionsOnRows(const FitProblem &problem)
{
    constexpr std::size_t kMostRows = 64;
    Positions whole;
    const std::vector<double> theta3 = courseOf(problem, Theta3, whole.isTheta3Whole);
    const std::vector<double> slider = courseOf(problem, R4x, whole.isR4xWhole);
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < problem.time.size(); ++row) {
        if ((theta3.empty() || !std::isnan(theta3[row])) && (slider.empty() || !std::isnan(slider[row]))) {
            rows.push_back(row);
        }
    }
    for (const std::size_t row : thinned(rows, kMostRows)) {
        whole.phase.push_back(problem.time[row]);
        if (!theta3.empty()) {
            whole.theta3.push_back(theta3[row]);
        }
        if (!slider.empty()) {
            whole.R4x.push_back(slider[row]);
        }
    }
    return whole;
}

Positions atSpeed(const Positions &rows, double speed)
{
    Positions positions = rows;
    for (double &phase : positions.phase) {
        phase *= speed;
    }
    return positions;
}

} // namespace

void lengthenCoupler(const FitProblem &problem, Parameters &parameters)
{
    constexpr double kMore = 1.0 + 1e-9;
    double longest = 0.0;
    for (const double t : problem.time) {
        const double theta2 = parameters.omega2 * t + parameters.theta20;
        longest = std::max(longest, std::abs(parameters.c - parameters.a * std::sin(theta2)));
    }
    parameters.b = std::max(parameters.b, kMore * longest);
}

void scaleToFit(const FitProblem &problem, Parameters &parameters)
{
    struct Sums {
        double xy = 0.0, xx = 0.0, x = 0.0, y = 0.0, n = 0.0;
    };
    std::vector<Sums> sums(problem.columns.size());
    InstantMotion motion;
    for (std::size_t row = 0; row < problem.time.size(); ++row) {
        if (!motion.computeValues(parameters, problem.time[row])) {
            return;
        }
        for (std::size_t k = 0; k < problem.columns.size(); ++k) {
            const FitColumn &column = problem.columns[k];
            if (isAngle(column.channel.coordinate) || std::isnan(column.values[row]) || !(column.spread > 0.0)) {
                continue;
            }
            const double x = motion.valueOf(column.channel) / column.spread;
            const double y = column.values[row] / column.spread;
            sums[k].xy += x * y;
            sums[k].xx += x * x;
            sums[k].x += x;
            sums[k].y += y;
            sums[k].n += 1.0;
        }
    }
    // About the means, so that an origin elsewhere does no harm.
    double products = 0.0;
    double squares = 0.0;
    for (const Sums &one : sums) {
        if (one.n > 0.0) {
            products += one.xy - one.x * one.y / one.n;
            squares += one.xx - one.x * one.x / one.n;
        }
    }
    const double scale = products / squares;
    if (squares > 0.0 && scale > 0.0 && std::isfinite(scale)) {
        parameters.a *= scale;
        parameters.b *= scale;
        parameters.c *= scale;
    }
}

double misfitOf(const FitProblem &problem, const Parameters &parameters)
{
    struct Sums {
        double residuals = 0.0, squares = 0.0, variance = 0.0;
    };
    std::vector<Sums> sums(problem.columns.size());
    InstantMotion motion;
    for (std::size_t row = 0; row < problem.time.size(); ++row) {
        if (!motion.computeValues(parameters, problem.time[row])) {
            return kUnbounded;
        }
        for (std::size_t k = 0; k < problem.columns.size(); ++k) {
            const FitColumn &column = problem.columns[k];
            if (std::isnan(column.values[row])) {
                continue;
            }
            double residual = motion.valueOf(column.channel) - column.values[row];
            if (isAngle(column.channel.coordinate) && column.channel.order == Order::Position) {
                residual = withoutTurns(residual);
            }
            sums[k].residuals += residual;
            sums[k].squares += residual * residual;
            sums[k].variance += column.variance[row];
        }
    }
    double misfit = 0.0;
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        const auto n = static_cast<double>(problem.columns[k].count);
        const double squares =
            sums[k].squares - (problem.columns[k].zero >= 0 ? sums[k].residuals * sums[k].residuals / n : 0.0);
        const double mean = std::max({squares / n, sums[k].variance / n, 1e-300});
        misfit += n * std::log(mean / (problem.columns[k].spread * problem.columns[k].spread));
    }
    return misfit;
}

std::vector<Parameters> startsOf(const FitProblem &problem, const std::vector<double> &speeds, double size,
                                 const std::stop_token &stop)
{
    constexpr std::size_t kRowMinima = 3;
    constexpr int kRowRefinements = 10;
    std::vector<Parameters> starts;
    const auto add = [&](const Route &route, const Positions &positions, double speed) {
        Shape shape = route.shape(positions);
        shape.parameters.omega2 = speed;
        const Parameters &p = shape.parameters;
        if (std::isfinite(p.a) && std::isfinite(p.b) && std::isfinite(p.c) && std::isfinite(p.theta20) && p.a > 0.0) {
            lengthenCoupler(problem, shape.parameters);
            // Angles alone know no size, and lengths have another one if the crank turns the other way. The size that
            // R4x tells may be better, or worse, than that of the shape when scaled.
            Parameters scaled = p;
            Parameters reversed{p.a, p.b, p.c, -p.omega2, pi - p.theta20, p.branch};
            scaleToFit(problem, scaled);
            starts.push_back(scaled);
            if (route.isOfTheta3) {
                scaleToFit(problem, reversed);
                starts.push_back(reversed);
            } else if (!isSameMechanism(scaled, p)) {
                starts.push_back(p);
            }
        }
    };
    const double crankSpeed = crankSpeedOf(problem);
    for (const double speed : speeds) {
        constexpr double kWholeTurn = 0.7;
        if (speed < 2.0 * pi * kWholeTurn) {
            continue;
        }
        const Positions positions = positionsOverATurn(problem, speed);
        for (const Route &route : routesFor(positions, size)) {
            add(route, positions, speed);
        }
    }
    const Positions rows = positionsOnRows(problem);
    constexpr std::size_t kFewest = 5;
    if (rows.phase.size() < kFewest || (rows.theta3.empty() && rows.R4x.empty())) {
        return starts;
    }
    std::vector<double> few;
    constexpr double kMostRadians = 2.0 * pi * 6.0;
    for (double speed = 0.1; speed < 4.0; speed *= 1.25) {
        few.push_back(speed);
    }
    for (double speed = 4.0; speed < kMostRadians; speed += 0.8) {
        few.push_back(speed);
    }
    for (const Route &route : routesFor(rows, size)) {
        const auto left = [&](double speed) {
            return stop.stop_requested() ? kUnbounded : route.shape(atSpeed(rows, speed)).left;
        };
        std::vector<double> best{std::abs(crankSpeed)};
        if (crankSpeed == 0.0) {
            std::vector<double> values(few.size());
            std::ranges::transform(few, values.begin(), left);
            best = minimaOver(few, values, kRowMinima, kRowRefinements, left);
        }
        for (const double speed : best) {
            add(route, atSpeed(rows, speed), speed);
        }
    }
    return starts;
}

bool isSameMechanism(const Parameters &x, const Parameters &y)
{
    constexpr double kSame = 1e-3;
    const double length = kSame * x.a;
    if (std::abs(x.a - y.a) > length || std::abs(x.b - y.b) > kSame * x.b ||
        std::abs(std::abs(x.c) - std::abs(y.c)) > std::max(length, kSame * std::abs(x.c)) ||
        std::abs(std::abs(x.omega2) - std::abs(y.omega2)) > kSame * std::abs(x.omega2)) {
        return false;
    }
    for (const Parameters &image : mirrorImages(y)) {
        constexpr double kSameAngle = 1e-2;
        if (std::abs(x.c - image.c) <= std::max(length, kSame * std::abs(x.c)) && x.omega2 * image.omega2 > 0.0 &&
            std::abs(std::remainder(x.theta20 - image.theta20, 2.0 * std::numbers::pi)) <= kSameAngle) {
            return true;
        }
    }
    return false;
}

std::vector<Parameters> distinct(std::span<const Parameters> mechanisms)
{
    std::vector<Parameters> some;
    for (const Parameters &one : mechanisms) {
        if (std::ranges::none_of(some, [&](const Parameters &other) { return isSameMechanism(other, one); })) {
            some.push_back(one);
        }
    }
    return some;
}

} // namespace slidercrank
