// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/crank_speed.h"

#include "core/identification/convention.h"
#include "core/identification/least_squares.h"
#include "core/import/crank_angles.h"
#include "core/mechanism/turn.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

namespace slidercrank
{

namespace
{

/// The column of θ2 or, if `orSpeed`, of its derivative; nullptr if the file has none.
const ObservedColumn *findCrank(const Observations &data, bool orSpeed)
{
    const std::size_t angle = columnIndex(data.columns, kCrankAngle);
    const std::size_t index =
        angle < data.columns.size() || !orSpeed ? angle : columnIndex(data.columns, {Theta2, Order::Velocity});
    return index < data.columns.size() ? &data.columns[index] : nullptr;
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
            const double unexplained = 1.0 - fitLinear(basis, column.values, column.mean).explained;
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

/// The mean speed of the crank by θ2 or its derivative; 0 if the file has neither.
double givenCrankSpeed(const Observations &data)
{
    const ObservedColumn *const crank = findCrank(data, true);
    return !crank                          ? 0.0
           : crank->channel == kCrankAngle ? fitLinear(powerBasis(data.abscissa, 2), crank->values).coefficients[1]
                                           : crank->mean;
}

/// The lowest minima of the periodogram, from the lowest.
std::vector<double> periodogramMinima(const Observations &data, double low, double high, double step)
{
    constexpr std::size_t kMost = 4;
    constexpr int kBits = 12; // accuracy of a speed
    const auto misfitAt = [&](double speed) { return harmonicMisfit(data, speed); };
    std::vector<double> misfits;
    for (double speed = low; speed < high + step; speed += step) {
        misfits.push_back(misfitAt(speed));
    }
    std::map<double, double> minima; // speeds by misfit
    for (std::size_t i = 0; i < misfits.size(); ++i) {
        if ((i == 0 || misfits[i] <= misfits[i - 1]) && (i + 1 == misfits.size() || misfits[i] <= misfits[i + 1])) {
            const double speed = low + static_cast<double>(i) * step;
            const auto [refined, misfit] =
                boost::math::tools::brent_find_minima(misfitAt, speed - step, speed + step, kBits);
            minima.emplace(misfit, refined);
        }
    }
    std::vector<double> best;
    for (const auto &[misfit, speed] : minima) {
        if (best.size() < kMost) {
            best.push_back(speed);
        }
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
        return {{1.0, data.unitOfHeading == 1.0 ? kDegreesPerRadian : 1.0 / data.unitOfHeading}, {}, true};
    }
    double known = std::abs(givenCrankSpeed(data));
    if (known != 0.0) {
        constexpr double kPrice = 24.0; // of another unit
        const double converted =
            known * nearestFactor(kAngleFactors, kDegreesPerRadian, findCrank(data, true)->unitOfHeading);
        const bool isConverted = harmonicMisfit(data, converted) + kPrice < harmonicMisfit(data, known);
        known = isConverted ? converted : known;
        if (findCrank(data, false)) {
            return {{known}, {}, true};
        }
    }
    constexpr double kLeastTurns = 0.7;
    constexpr double kMostCrossingsOfArc = 6.0;
    constexpr double kLongestStep = 2.0; // mean steps
    const double crossings = meanCrossings(data);
    const double span = data.span();
    double covered = 0.0; // time, without gaps in which the crank may turn unseen
    for (std::size_t i = 1; i < data.abscissa.size(); ++i) {
        covered += std::min(data.abscissa[i] - data.abscissa[i - 1],
                            kLongestStep * span / static_cast<double>(data.abscissa.size()));
    }
    // At most half of the sampling frequency, and little more than the number of mean crossings suggests.
    const double high =
        std::min(std::numbers::pi / data.interval() * 1.02, 1.2 * std::numbers::pi * (crossings + 3.0) / covered);
    SpeedCandidates speeds{periodogramMinima(data, kLeastTurns * kTurn / span, high, 1.0 / span), {}, false};
    if (known != 0.0) { // the speed in the file may be a set one
        speeds.periodic.insert(speeds.periodic.begin(), known);
    }
    if (crossings <= kMostCrossingsOfArc) {
        for (double angle = 0.1; angle < 8.0; angle *= 1.5) {
            speeds.shortArc.push_back(angle / span);
        }
    }
    return speeds;
}

std::optional<CrankSpeedChange> crankSpeedChange(const Observations &data)
{
    constexpr double kFewestRows = 8.0;
    constexpr double kSteps = 12.0;     // of the angle, in the time of a speed: speeds farther apart differ
    constexpr double kLeastPart = 5e-3; // of the speed: less may be an error of the file's integrator or filter
    const ObservedColumn *const angle = findCrank(data, false);
    if (!angle || angle->count < kFewestRows) {
        return std::nullopt;
    }
    const std::span<const double> times = data.abscissa;
    const std::span<const double> angles = angle->values;
    const auto isJump = [](double before, double after) { return std::abs(after - before) > kQuarterTurn; };
    if (std::ranges::adjacent_find(angles, isJump) != angles.end()) { // a wrong value, or an interpolated wrap
        return std::nullopt;
    }
    const Eigen::VectorXd line = fitLinear(powerBasis(times, 2), angles).coefficients;
    std::vector<double> residuals;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!std::isnan(angles[i])) {
            residuals.push_back(angles[i] - line[0] - line[1] * times[i]);
        }
    }
    if (autocorrelation(residuals, 1) <= 3.0) { // white noise
        return std::nullopt;
    }
    // As few rows as determine the speed to about 1 %, a tenth of all at most.
    const auto n = static_cast<double>(times.size());
    const double speed = std::abs(line[1]);
    const double step = speed * data.printedStep + angle->step;
    const double enough = std::pow(400.0 * step * n / (speed * data.span()), 2.0 / 3.0);
    const auto rows = static_cast<std::size_t>(std::max(3.0, std::min(enough, n / 10.0)));
    const auto speedAt = [&](std::size_t first, double end) { // by a parabola
        const Eigen::VectorXd coefficients =
            fitLinear(powerBasis(times.subspan(first, rows), 3), angles.subspan(first, rows)).coefficients;
        return coefficients[1] + 2.0 * coefficients[2] * end;
    };
    const CrankSpeedChange change{speedAt(0, times.front()), speedAt(times.size() - rows, times.back())};
    return std::abs(change.atEnd - change.atStart) >
                   std::max(kSteps * step * n / (data.span() * static_cast<double>(rows)), kLeastPart * speed)
               ? std::optional(change)
               : std::nullopt;
}

} // namespace slidercrank
