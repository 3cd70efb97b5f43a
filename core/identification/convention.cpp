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

/// Adds an amount to values. They keep their decimals, but not their significant digits.
void shift(std::vector<double> &values, Rounding &rounding, double amount)
{
    rounding = rounding.withDecimalsAt(rangeOf(values).size());
    for (double &value : values) {
        value += amount;
    }
}

/// Changes the values of a column, the time stamps, or the angles of a table over the crank angle. `timePower`: the
/// exponent of the unit of time in the unit of the values: -2 for an acceleration, 1 for the time stamps.
void changeValues(const Convention &convention, int timePower, std::vector<double> &values, Rounding &rounding)
{
    const Kind kind = convention.kind;
    const bool unwraps = kind == Kind::HalfTurn || kind == Kind::WholeTurns;
    if (unwraps) {
        // The decimals remain those before jumps are removed: those of 359.948, and not those of -0.052.
        rounding = rounding.withDecimalsAt(rangeOf(values).size());
        removeJumps(values, kTurnInDegrees);
    }
    if (unwraps || kind == Kind::ZeroPoint || kind == Kind::TimeShift) {
        shift(values, rounding, convention.amount);
    } else { // kinds that do not change values have the amount 1
        multiply(values, rounding, kind == Kind::TimeUnit ? std::pow(convention.amount, timePower) : convention.amount);
    }
}

/// Rotates the axes of a column, so that a slider that moves along y moves along x: y becomes x, x becomes -y, and
/// angles are measured from the new x axis.
void rotateAxes(ReferenceSeries &series)
{
    if (isAngle(series.channel.coordinate)) {
        shift(series.values, series.rounding, -0.25 * kTurnInDegrees);
    } else if (series.channel.coordinate == R4x) {
        series.channel.coordinate = R4y;
        multiply(series.values, series.rounding, -1.0);
    } else {
        series.channel.coordinate = R4x;
    }
}

} // namespace

bool concerns(const Convention &convention, Channel channel)
{
    return std::ranges::find(convention.channels, channel) != convention.channels.end();
}

ReferenceData applied(const Convention &convention, ReferenceData data)
{
    if (data.crank && concerns(convention, kCrankAngle)) { // timedBy() computes the time stamps from the angles
        changeValues(convention, 0, data.crank->degrees, data.crank->rounding);
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
            changeValues(convention, -static_cast<int>(series.channel.order), series.values, series.rounding);
        }
    }
    if (convention.kind == Kind::TimeUnit || convention.kind == Kind::TimeShift) {
        changeValues(convention, 1, data.time, data.timeRounding);
    } else if (convention.kind == Kind::NotDerivative) {
        std::erase_if(data.series, [&](const ReferenceSeries &series) { return concerns(convention, series.channel); });
    }
    return data;
}

} // namespace slidercrank
