// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/convention.h"

#include "core/import/crank_angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

void multiply(std::vector<double> &values, Rounding &rounding, double factor)
{
    for (double &value : values) {
        value *= factor;
    }
    rounding.unitFactor *= std::abs(factor);
}

/// A shifted column keeps its decimals, but not its significant digits.
void shift(std::vector<double> &values, Rounding &rounding, double amount)
{
    rounding = rounding.withDecimalsAt(rangeOf(values).size());
    for (double &value : values) {
        value += amount;
    }
}

/// Changes the values of a column, the time stamps, or the angles of a table over the crank angle. `timePower`: the
/// exponent of the unit of time in the unit of the values: -2 for an acceleration, 1 for the time stamps.
void change(const Convention &convention, int timePower, std::vector<double> &values, Rounding &rounding)
{
    const Kind kind = convention.kind;
    const bool unwraps = kind == Kind::HalfTurn || kind == Kind::WholeTurns;
    if (unwraps) {
        removeJumps(values, 360.0);
    }
    if (unwraps || kind == Kind::ZeroPoint || kind == Kind::TimeShift) {
        shift(values, rounding, convention.amount);
    } else { // kinds without a factor have the amount 1
        multiply(values, rounding, kind == Kind::TimeUnit ? std::pow(convention.amount, timePower) : convention.amount);
    }
}

/// Rotates the axes of a column, so that a slider that moves along y moves along x: y becomes x, x becomes -y, and
/// angles are measured from the new x axis.
void rotateAxes(ReferenceSeries &series)
{
    constexpr double kQuarterTurn = 90.0; // °
    if (isAngle(series.channel.coordinate)) {
        shift(series.values, series.rounding, -kQuarterTurn);
    } else if (series.channel.coordinate == R4x) {
        series.channel.coordinate = R4y;
        multiply(series.values, series.rounding, -1.0);
    } else {
        series.channel.coordinate = R4x;
    }
}

/// Whether the slider moves along y and not along x, by its positions, velocities and accelerations.
bool movesAlongY(const ReferenceData &data)
{
    constexpr double kStationaryFraction = 1e-3; // of the motion along the other axis: rounding or misalignment
    const auto widthOf = [&](Channel channel) {
        const ReferenceSeries *const series = data.find(channel);
        return series ? rangeOf(series->values).width() : 0.0;
    };
    bool moves = false;
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        const double alongX = widthOf({R4x, order});
        const double alongY = widthOf({R4y, order});
        if (alongX > kStationaryFraction * alongY) {
            return false;
        }
        moves = moves || alongY > 0.0;
    }
    return moves;
}

} // namespace

double nearestFactor(std::span<const double> units, double wanted, double unitOfHeading)
{
    const auto distance = [&](double factor) { return std::abs(std::log(std::abs(wanted) / factor)); };
    double nearest = 1.0;
    for (const double unit : units) {
        for (const double factor : {unit, 1.0 / unit}) {
            const bool isPossible =
                unitOfHeading == 1.0 ? factor == unit : std::abs(factor * unitOfHeading - 1.0) < kSameUnit;
            nearest = isPossible && distance(factor) < distance(nearest) ? factor : nearest;
        }
    }
    return nearest;
}

bool concerns(const Convention &convention, Channel channel)
{
    return std::ranges::find(convention.channels, channel) != convention.channels.end();
}

std::optional<Convention> axisAlongY(const ReferenceData &data, bool withAngles)
{
    if (!movesAlongY(data)) {
        return std::nullopt;
    }
    Convention axis{.kind = Kind::Axis, .channels = {}};
    for (const ReferenceSeries &series : data.series) {
        const Channel channel = series.channel;
        const bool isOfSlider = channel.coordinate == R4x || channel.coordinate == R4y;
        const bool isDirection = isAngle(channel.coordinate) && channel.order == Order::Position;
        if (isOfSlider || (withAngles && isDirection)) {
            axis.channels.push_back(channel);
        }
    }
    return axis;
}

ReferenceData applied(const Convention &convention, ReferenceData data)
{
    if (data.crank && concerns(convention, kCrankAngle)) { // timedBy() computes the time stamps from the angles
        change(convention, 0, data.crank->degrees, data.crank->rounding);
    }
    for (ReferenceSeries &series : data.series) {
        if (!concerns(convention, series.channel)) {
            continue;
        }
        if (convention.kind == Kind::SwappedColumns) {
            series.channel = convention.channels[series.channel == convention.channels[0] ? 1 : 0];
        } else if (convention.kind == Kind::Axis) {
            rotateAxes(series);
        } else {
            change(convention, -static_cast<int>(series.channel.order), series.values, series.rounding);
        }
    }
    if (convention.kind == Kind::TimeUnit || convention.kind == Kind::TimeShift) {
        change(convention, 1, data.time, data.timeRounding);
    } else if (convention.kind == Kind::NotDerivative) {
        std::erase_if(data.series, [&](const ReferenceSeries &series) { return concerns(convention, series.channel); });
    }
    return data;
}

} // namespace slidercrank
