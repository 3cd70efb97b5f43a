// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How the limits of the motion depend on one parameter, as plain data. Units: mm, degrees, mm/s, mm/s², rad/s.

#include "core/mechanism/mechanism.h"
#include "ui/text/interval.h"

#include <QString>

#include <array>
#include <stop_token>
#include <vector>

namespace slidercrank
{

enum class Limit { Stroke, TimeRatio, TransmissionAngle, SliderSpeed, SliderAcceleration };
inline constexpr std::size_t kLimitCount = 5;

/// By Limit; NaN where the limit does not exist, infinite where a peak is unbounded.
using LimitValues = std::array<double, kLimitCount>;

LimitValues limitValues(const Mechanism &mechanism);

/// The parameters that the limits depend on.
inline constexpr std::array kVariedParameters{Parameter::A, Parameter::B, Parameter::C, Parameter::Omega2};

struct ResponseRange {
    Interval assembled; ///< where the mechanism can be assembled; cut where that has no end
    Interval fullTurn;  ///< may reach beyond it; lower > upper if there is no such value
};

/// With all other parameters as they are. Contains the present value wherever the mechanism can be assembled.
ResponseRange responseRange(const Parameters &parameters, Parameter parameter);

/// For which values the crank makes full turns; empty if for all.
QString fullTurnText(Parameter parameter, const ResponseRange &range);

struct Response {
    Parameters parameters;
    Parameter parameter = Parameter::B;
    ResponseRange range;
    std::vector<double> values{}; ///< of the parameter, ascending
    std::vector<LimitValues> limits{};
};

/// At `count` equally spaced values (at least 2) and the ends of the range of full turns. Ends early if stopped.
Response computeResponse(const Parameters &parameters, Parameter parameter, const ResponseRange &range, int count,
                         const std::stop_token &stop = {});

} // namespace slidercrank
