// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/uneven_crank.h"

#include "core/identification/crank_speed.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// θ2 without whole turns, or its derivative, row by row where it has a value; FitUnits.
struct CrankCourse {
    std::vector<double> times;
    std::vector<double> values;
    bool isAngle = false;
    double step = 0.0; ///< of the values' rounding
};

std::optional<CrankCourse> courseOf(const Observations &all)
{
    const auto columnAt = [&](Order order) -> const ObservedColumn * {
        const auto found = std::ranges::find(all.columns, Channel{Theta2, order}, &ObservedColumn::channel);
        return found == all.columns.end() ? nullptr : &*found;
    };
    constexpr std::size_t kFewestRows = 8;
    const ObservedColumn *angle = columnAt(Order::Position);
    const ObservedColumn *column = angle ? angle : columnAt(Order::Velocity);
    if (!column || column->count < kFewestRows) {
        return std::nullopt;
    }
    const double speedOnAverage = crankSpeedOf(problemOf(all, asWritten(all)));
    const double unit = all.units.factor(column->channel);
    CrankCourse course{{}, {}, angle != nullptr, unit * column->step};
    for (std::size_t row = 0; row < all.time.size(); ++row) {
        double value = unit * column->values[row];
        if (std::isnan(value)) {
            continue;
        }
        if (angle && !course.values.empty()) {
            const double last = course.values.back();
            const double expected = speedOnAverage * (all.time[row] - course.times.back());
            value = last + expected + withoutTurns(value - last - expected);
        }
        course.times.push_back(all.time[row]);
        course.values.push_back(value);
    }
    return course;
}

struct Line {
    double slope = 0.0;
    double origin = 0.0;
};

/// Least squares; of a speed its mean.
Line lineThrough(const CrankCourse &course)
{
    const auto count = static_cast<double>(course.times.size());
    double t = 0.0, y = 0.0, tt = 0.0, ty = 0.0;
    for (std::size_t i = 0; i < course.times.size(); ++i) {
        t += course.times[i] / count;
        y += course.values[i] / count;
    }
    if (!course.isAngle) {
        return {0.0, y};
    }
    for (std::size_t i = 0; i < course.times.size(); ++i) {
        tt += (course.times[i] - t) * (course.times[i] - t);
        ty += (course.times[i] - t) * (course.values[i] - y);
    }
    return {ty / tt, y - ty / tt * t};
}

/// What an even crank leaves is rounding, or looks like noise. `rounding`: of a value and of its instant.
bool isEven(const CrankCourse &course, const Line &line, double rounding)
{
    double squares = 0.0;
    double products = 0.0;
    double before = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < course.times.size(); ++i) {
        const double residual = course.values[i] - line.origin - line.slope * course.times[i];
        squares += residual * residual;
        products += i > 0 ? residual * before : 0.0;
        before = residual;
        largest = std::max(largest, std::abs(residual));
    }
    constexpr double kSmall = 1e-4; // of a radian, or of the speed: nobody would call that uneven
    const double small = kSmall * (course.isAngle ? 1.0 : std::abs(line.origin));
    const bool isRounding = largest <= 2.0 * rounding + small;
    return isRounding || products <= 3.0 / std::sqrt(static_cast<double>(course.times.size())) * squares;
}

/// From there on, by a parabola through so many rows of an angle.
template <class Iterator>
double speedAt(Iterator time, Iterator value, std::ptrdiff_t rows)
{
    Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    const double first = *time;
    for (std::ptrdiff_t i = 0; i < rows; ++i, ++time, ++value) {
        const double t = *time - first;
        const Eigen::Vector3d basis(1.0, t, t * t);
        sums += basis * basis.transpose();
        right += *value * basis;
    }
    return Eigen::Vector3d(sums.ldlt().solve(right))[1];
}

} // namespace

std::optional<CrankSpeedChange> unevenCrankOf(const Observations &all)
{
    const std::optional<CrankCourse> course = courseOf(all);
    if (!course) {
        return std::nullopt;
    }
    const Line line = lineThrough(*course);
    const double rounding = course->step + std::abs(line.slope) * all.printedClockStep;
    if (isEven(*course, line, rounding)) {
        return std::nullopt;
    }
    const double scale = 1.0 / all.units.second;
    if (!course->isAngle) {
        return CrankSpeedChange{scale * course->values.front(), scale * course->values.back()};
    }
    // As few rows as their rounding lets tell the speed to about a hundredth.
    const auto n = static_cast<std::ptrdiff_t>(course->times.size());
    const double interval = (course->times.back() - course->times.front()) / static_cast<double>(n - 1);
    std::ptrdiff_t part = 4;
    while (part < n / 10 &&
           4.0 * rounding / (std::pow(static_cast<double>(part), 1.5) * interval) > 0.01 * std::abs(line.slope)) {
        ++part;
    }
    return CrankSpeedChange{scale * speedAt(course->times.begin(), course->values.begin(), part),
                            scale * speedAt(course->times.rbegin(), course->values.rbegin(), part)};
}

} // namespace slidercrank
