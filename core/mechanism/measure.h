// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The kinds of quantities that the program shows. The kind decides the unit: the core computes in mm, rad and s; files
// and the screen have mm, degrees and s unless a person chooses other units.

#include "core/mechanism/channel.h"

namespace slidercrank
{

enum class Measure { Ratio, Time, Length, Speed, Acceleration, Angle, AngularSpeed, AngularAcceleration };

constexpr bool isAngular(Measure measure)
{
    return measure == Measure::Angle || measure == Measure::AngularSpeed || measure == Measure::AngularAcceleration;
}

constexpr bool isLinear(Measure measure)
{
    return measure == Measure::Length || measure == Measure::Speed || measure == Measure::Acceleration;
}

/// Returns the measure of an angle, or of its derivative of that order.
constexpr Measure angleMeasure(Order order)
{
    switch (order) {
    case Order::Position: return Measure::Angle;
    case Order::Velocity: return Measure::AngularSpeed;
    case Order::Acceleration: break;
    }
    return Measure::AngularAcceleration;
}
/// Returns the measure of a length, or of its derivative of that order.
constexpr Measure lengthMeasure(Order order)
{
    switch (order) {
    case Order::Position: return Measure::Length;
    case Order::Velocity: return Measure::Speed;
    case Order::Acceleration: break;
    }
    return Measure::Acceleration;
}
constexpr Measure measureOf(Channel channel)
{
    return isAngle(channel.coordinate) ? angleMeasure(channel.order) : lengthMeasure(channel.order);
}

/// Converts a value from the core's unit (mm, rad, s) to that of files (mm, °, s).
constexpr double toFileUnit(Measure measure, double value)
{
    return isAngular(measure) ? value * kDegreesPerRadian : value;
}

} // namespace slidercrank
