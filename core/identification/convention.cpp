// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/convention.h"

#include "core/identification/observations.h"
#include "core/import/crank_angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

void multiply(ReferenceSeries &series, double factor)
{
    for (double &value : series.values) {
        value *= factor;
    }
    series.rounding.unitFactor *= std::abs(factor);
}

/// Fixes the rounding step before a shift: a shifted column keeps its decimals, but not its significant digits.
void keepDecimals(ReferenceSeries &series)
{
    series.rounding = series.rounding.withDecimalsAt(rangeOf(series.values).size());
}

void shift(ReferenceSeries &series, double amount)
{
    keepDecimals(series);
    for (double &value : series.values) {
        value += amount;
    }
}

/// Turns a column by -90 degrees.
void turn(ReferenceSeries &series)
{
    constexpr double kQuarterTurn = 90.0;
    if (isAngle(series.channel.coordinate)) {
        shift(series, -kQuarterTurn);
    } else if (series.channel.coordinate == R4x) {
        series.channel.coordinate = R4y;
        multiply(series, -1.0);
    } else {
        series.channel.coordinate = R4x;
    }
}

/// Changes the angles of a file by crank angle. timedBy() computes the time stamps from them.
void applyToAngles(const Convention &convention, CrankAngles &crank)
{
    const bool isShift = convention.kind == Kind::ZeroPoint;
    for (double &angle : crank.degrees) {
        angle = isShift ? angle + convention.amount : angle * convention.amount;
    }
    if (isShift) {
        crank.rounding = crank.rounding.withDecimalsAt(rangeOf(crank.degrees).size());
    } else {
        crank.rounding.unitFactor *= std::abs(convention.amount);
    }
}

void applyToTime(const Convention &convention, ReferenceData &data)
{
    const bool isUnit = convention.kind == Kind::TimeUnit;
    if (isUnit && data.crank) { // the model determines its time stamps
        return;
    }
    for (double &time : data.time) {
        time = isUnit ? time * convention.amount : time + convention.amount;
    }
    data.timeRounding.unitFactor *= isUnit ? std::abs(convention.amount) : 1.0;
}

} // namespace

double nearestFactor(std::span<const double> factors, double wanted)
{
    return *std::ranges::min_element(factors, {},
                                     [&](double factor) { return std::abs(std::log(std::abs(wanted) / factor)); });
}

bool concerns(const Convention &convention, Channel channel)
{
    return std::ranges::find(convention.channels, channel) != convention.channels.end();
}

std::optional<Convention> axisAlongY(const ReferenceData &data, bool withAngles)
{
    constexpr double kStationaryPart = 1e-3; // of the motion along the other axis: rounding or misalignment
    Convention axis{Convention::Kind::Axis, {}, 1.0};
    bool movesAlongY = false;
    for (const ReferenceSeries &series : data.series) {
        if (withAngles && isAngle(series.channel.coordinate) && series.channel.order == Order::Position) {
            axis.channels.push_back(series.channel);
        }
        if (series.channel.coordinate != R4x && series.channel.coordinate != R4y) {
            continue;
        }
        movesAlongY = true;
        axis.channels.push_back(series.channel);
        const ReferenceSeries *const other =
            data.find({series.channel.coordinate == R4x ? R4y : R4x, series.channel.order});
        const double width = rangeOf(series.values).width();
        const double otherWidth = other ? rangeOf(other->values).width() : 0.0;
        const bool isUpright = series.channel.coordinate == R4y ? width > 0.0 && otherWidth <= kStationaryPart * width
                                                                : width <= kStationaryPart * otherWidth;
        if (!isUpright) {
            return std::nullopt;
        }
    }
    return movesAlongY ? std::optional(std::move(axis)) : std::nullopt;
}

ReferenceData applied(const Convention &convention, ReferenceData data)
{
    if (data.crank && concerns(convention, kCrankAngle)) {
        applyToAngles(convention, *data.crank);
    }
    for (ReferenceSeries &series : data.series) {
        if (!concerns(convention, series.channel)) {
            continue;
        }
        switch (convention.kind) {
        case Kind::AngleUnit:
        case Kind::LengthUnit:
        case Kind::Sign: multiply(series, convention.amount); break;
        case Kind::TimeUnit:
            multiply(series, std::pow(convention.amount, -static_cast<int>(series.channel.order)));
            break;
        case Kind::HalfTurn:
        case Kind::WholeTurns:
            keepDecimals(series);
            removeJumps(series.values, 360.0);
            shift(series, convention.amount);
            break;
        case Kind::ZeroPoint: shift(series, convention.amount); break;
        case Kind::SwappedColumns:
            series.channel = convention.channels[series.channel == convention.channels[0] ? 1 : 0];
            break;
        case Kind::Axis: turn(series); break;
        case Kind::Branch:
        case Kind::TimeShift:
        case Kind::NotDerivative: break;
        }
    }
    if (convention.kind == Kind::TimeUnit || convention.kind == Kind::TimeShift) {
        applyToTime(convention, data);
    } else if (convention.kind == Kind::NotDerivative) {
        std::erase_if(data.series, [&](const ReferenceSeries &series) { return concerns(convention, series.channel); });
    }
    return data;
}

} // namespace slidercrank
