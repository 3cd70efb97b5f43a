// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/response.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

ResponseLimits responseLimits(const Mechanism &mechanism)
{
    const std::vector<Limit> limits = findLimits(mechanism, motionLimits(mechanism));
    ResponseLimits values;
    std::ranges::transform(kResponseLimits, values.begin(), [&limits](LimitKind kind) {
        const double value = valueOf(limits, kind);
        const double magnitude = peakChannel(kind) ? std::abs(value) : value;
        return std::isfinite(magnitude) ? magnitude : kNone;
    });
    return values;
}

ParameterRanges parameterRanges(const Parameters &parameters, Parameter parameter)
{
    const double a = parameters.a;
    const double b = parameters.b;
    const double c = std::abs(parameters.c);
    switch (parameter) {
    case Parameter::A: {
        const double shortest = std::max(kShortestLink, c - b);
        return {.assembled = {shortest, kLargestParameter}, .fullTurn = {shortest, b - c}};
    }
    case Parameter::B:
        return {.assembled = {std::max(kShortestLink, c - a), kLargestParameter},
                .fullTurn = {a + c, kLargestParameter}};
    case Parameter::C: return {.assembled = {-(a + b), a + b}, .fullTurn = {a - b, b - a}};
    case Parameter::Omega2:
    case Parameter::Theta20: break;
    }
    constexpr ParameterRange kAllValues{-kLargestParameter, kLargestParameter};
    constexpr ParameterRange kEmpty{.lower = 1.0, .upper = -1.0};
    return {.assembled = kAllValues, .fullTurn = b >= a + c ? kAllValues : kEmpty};
}

} // namespace slidercrank
