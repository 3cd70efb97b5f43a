// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/column_motion.h"

#include "core/import/reference_data.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace slidercrank
{

namespace
{

constexpr std::size_t kFewestSamples = 8; ///< fewer values say nothing of how a quantity moves

/// Trapezoids over steps of 12° of the crank are off by 1 %, and files have rounding: a derivative in another unit, or
/// of something else, is off by far more.
constexpr double kDerivativeTolerance = 0.05;

/// What changes by less than this part of itself is constant, for a column of a few digits.
constexpr double kEvenness = 1e-3;

/// The residual, of the whole, of sin θ3 as a sinusoid: rounding leaves less; a slider's position more, unless the
/// coupler is some fifty times as long as the crank. Between the two limits nothing is said.
constexpr double kAngleResidual = 0.01;
constexpr double kLengthResidual = 0.05;

/// The part of s̈ that is not a straight line of s = sin(angle), falling; 1 where there is none. sin θ3 = (c - a sin
/// θ2)/b is a sinusoid, so the coupler's angle leaves nothing.
double residualAsAngle(const std::vector<double> &angle, const std::vector<double> &velocity,
                       const std::vector<double> &acceleration, double degreesPerUnit)
{
    double count = 0.0;
    double meanS = 0.0;
    double meanD = 0.0;
    double ss = 0.0;
    double sd = 0.0;
    double dd = 0.0;
    for (std::size_t i = 0; i < angle.size(); ++i) {
        const double theta = angle[i] * degreesPerUnit / kDegreesPerRadian;
        const double omega = velocity[i] * degreesPerUnit / kDegreesPerRadian;
        const double alpha = acceleration[i] * degreesPerUnit / kDegreesPerRadian;
        const double s = std::sin(theta);
        const double d = std::cos(theta) * alpha - s * omega * omega;
        if (!std::isfinite(s) || !std::isfinite(d)) {
            continue;
        }
        // Means and sums of squares in one pass (Welford).
        count += 1.0;
        const double offS = s - meanS;
        const double offD = d - meanD;
        meanS += offS / count;
        meanD += offD / count;
        ss += offS * (s - meanS);
        dd += offD * (d - meanD);
        sd += offS * (d - meanD);
    }
    if (count < static_cast<double>(kFewestSamples) || !(ss > 0.0) || !(dd > 0.0) || !(sd < 0.0)) {
        return 1.0;
    }
    return std::sqrt(std::max(0.0, 1.0 - sd / ss * sd / dd));
}

} // namespace

bool onlyRises(const std::vector<double> &values)
{
    return values.size() >= 2 && std::ranges::all_of(values, [](double value) { return std::isfinite(value); }) &&
           std::ranges::adjacent_find(values, [](double x, double y) { return !(x < y); }) == values.end();
}

bool isEven(const std::vector<double> &time, const std::vector<double> &values, Order order)
{
    const ValueRange range = rangeOf(values);
    if (range.count < kFewestSamples) {
        return false;
    }
    switch (order) {
    case Order::Position: {
        if (range.count != values.size() || !(range.width() > 0.0) || !onlyRises(time)) {
            return false;
        }
        const double slope = (values.back() - values.front()) / (time.back() - time.front());
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!(std::abs(values.front() + slope * (time[i] - time.front()) - values[i]) <=
                  kEvenness * range.width())) {
                return false;
            }
        }
        return true;
    }
    case Order::Velocity: return range.size() > 0.0 && range.width() <= kEvenness * range.size();
    case Order::Acceleration: return range.size() == 0.0;
    }
    return false;
}

/// By its integral: differences of rounded values would be noise.
bool isDerivative(const std::vector<double> &time, const std::vector<double> &values, const std::vector<double> &rate)
{
    double integral = 0.0;
    double worst = 0.0;
    double largest = 0.0; // of the integral
    std::size_t count = 0;
    std::optional<std::size_t> first;
    std::size_t last = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (!std::isfinite(time[i]) || !std::isfinite(values[i]) || !std::isfinite(rate[i])) {
            continue;
        }
        if (first) {
            integral += 0.5 * (rate[last] + rate[i]) * (time[i] - time[last]);
            worst = std::max(worst, std::abs(values[i] - values[*first] - integral));
            largest = std::max(largest, std::abs(integral));
        } else {
            first = i;
        }
        last = i;
        ++count;
    }
    return count < kFewestSamples || worst <= kDerivativeTolerance * std::max(rangeOf(values).width(), largest);
}

std::optional<Dimension> dimensionOf(const std::vector<double> &position, const std::vector<double> &velocity,
                                     const std::vector<double> &acceleration)
{
    const double residual = std::min(residualAsAngle(position, velocity, acceleration, 1.0),
                                     residualAsAngle(position, velocity, acceleration, kDegreesPerRadian));
    if (residual < kAngleResidual) {
        return Dimension::Angle;
    }
    return residual > kLengthResidual ? std::optional(Dimension::Length) : std::nullopt;
}

} // namespace slidercrank
