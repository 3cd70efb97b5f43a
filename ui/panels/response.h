// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The curves of the limits of the motion over one parameter.

#include "core/limits/response.h"
#include "ui/text/interval.h"

#include <QString>

#include <array>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// The values of the limits, in the order of kResponseLimits, in the units that are shown. A value is NaN if the limit
/// does not exist or is unbounded.
using LimitValues = ResponseLimits;

LimitValues limitValues(const Mechanism &mechanism);

/// The parameters that affect the limits.
inline constexpr std::array kVariedParameters{Parameter::A, Parameter::B, Parameter::C, Parameter::Omega2};

struct ResponseRange {
    Interval assembled; ///< values with which the mechanism can be assembled; distant ends are cut off
    Interval fullTurn;  ///< values with which the crank makes full turns; may exceed `assembled`; lower > upper if
                        ///< there are none
};

/// Returns the range of one parameter, with all others fixed. It contains the current value if the mechanism can be
/// assembled.
ResponseRange responseRange(const Parameters &parameters, Parameter parameter);

/// Returns a sentence that names the values with which the crank makes full turns; empty if these are all values.
QString fullTurnText(Parameter parameter, const ResponseRange &range);

struct Response {
    Parameters parameters;
    Parameter parameter = Parameter::B;
    ResponseRange range;
    std::vector<double> values{}; ///< of the parameter, ascending
    std::vector<LimitValues> limits{};
};

/// Computes the limits at `count` (at least 2) equally spaced values, and at and next to the ends of the ranges. If
/// `stop` is requested, the remaining limits are NaN.
Response computeResponse(const Parameters &parameters, Parameter parameter, int count,
                         const std::stop_token &stop = {});

} // namespace slidercrank
