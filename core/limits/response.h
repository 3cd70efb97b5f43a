// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes how the limits of a motion depend on one parameter, and for which of its values the crank makes full turns.
// Lengths in mm, angles in rad, time in s.

#include "core/limits/limit.h"

#include <array>

namespace slidercrank
{

/// The limits whose response to a parameter is shown.
inline constexpr std::array kResponseLimits{LimitKind::Stroke, LimitKind::TimeRatio,
                                            LimitKind::MinimumTransmissionAngle, LimitKind::PeakSliderSpeed,
                                            LimitKind::PeakSliderAcceleration};
using ResponseLimits = std::array<double, kResponseLimits.size()>; ///< in the order of kResponseLimits

/// Returns the values of kResponseLimits; for a peak, its magnitude. A value is NaN if the limit does not exist or is
/// unbounded.
ResponseLimits responseLimits(const Mechanism &mechanism);

/// A range of values of one parameter; empty if lower > upper.
struct ParameterRange {
    double lower = 0.0;
    double upper = 0.0;
};

struct ParameterRanges {
    ParameterRange assembled; ///< the mechanism can be assembled
    ParameterRange fullTurn;  ///< the crank makes full turns: b >= a + |c|
};

/// Returns the ranges of one parameter within ±kLargestParameter, with the other parameters fixed. For ω2 and θ20,
/// `assembled` contains all values, even if the mechanism cannot be assembled.
ParameterRanges parameterRanges(const Parameters &parameters, Parameter parameter);

} // namespace slidercrank
