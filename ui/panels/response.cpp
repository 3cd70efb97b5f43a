// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/response.h"

#include "ui/text/notation.h"
#include "ui/text/parameter_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct ResponseText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ResponseText)
};

} // namespace

LimitValues limitValues(const Mechanism &mechanism)
{
    LimitValues values = responseLimits(mechanism);
    std::ranges::transform(values, kResponseLimits, values.begin(), [](double value, LimitKind kind) {
        return shownValue(describe(kind).measure, value, notation().units);
    });
    return values;
}

ResponseRange responseRange(const Parameters &parameters, Parameter parameter)
{
    const double a = parameters.a;
    const double b = parameters.b;
    const double c = std::abs(parameters.c);
    const double value = valueOf(parameters, parameter);
    const auto &[assembled, fullTurn] = parameterRanges(parameters, parameter);
    Interval shown{assembled.lower, assembled.upper};
    Interval shownFullTurn{fullTurn.lower, fullTurn.upper};
    // Cuts the range at `end`, or beyond the current value.
    const auto cutAbove = [&shown, value](double end) {
        shown.upper = std::min(std::max(end, 1.25 * value), shown.upper);
    };
    switch (parameter) {
    case Parameter::A: cutAbove(b > c ? 1.5 * (b - c) : 2.0 * (b + c)); break;
    case Parameter::B: cutAbove(3.0 * (a + c)); break;
    case Parameter::C: break;
    case Parameter::Omega2:
    case Parameter::Theta20: {
        const double end = nextRoundNumber(std::max(1.25 * std::abs(value), 1.0));
        shown = {-end, end};
        if (!shownFullTurn.isEmpty()) { // then the crank turns fully for every value
            shownFullTurn = shown;
        }
        break;
    }
    }
    return {shown, shownFullTurn};
}

QString fullTurnText(Parameter parameter, const ResponseRange &range)
{
    const auto &[lower, upper] = range.fullTurn;
    const bool hasLower = lower > range.assembled.lower;
    const bool hasUpper = upper < range.assembled.upper;
    const QString symbol = symbolText(parameter);
    if (range.fullTurn.isEmpty()) {
        return ResponseText::tr("The crank makes full turns for no value of %1.").arg(symbol);
    }
    if (hasLower && hasUpper) {
        return ResponseText::tr("The crank makes full turns for %1 ≤ %2 ≤ %3; the rest is shaded.")
            .arg(lengthText(lower), symbol, lengthText(upper));
    }
    if (hasLower) {
        return ResponseText::tr("The crank makes full turns for %1 ≥ %2; the rest is shaded.")
            .arg(symbol, lengthText(lower));
    }
    if (hasUpper) {
        return ResponseText::tr("The crank makes full turns for %1 ≤ %2; the rest is shaded.")
            .arg(symbol, lengthText(upper));
    }
    return {};
}

/// Returns `count` equally spaced values, and more of them next to the ends of the ranges. There the limits have
/// vertical tangents like those of a square root, which straight lines between equally spaced values would cut off.
static std::vector<double> responseValues(const ResponseRange &range, int count)
{
    constexpr int kValuesBesideEnd = 8; // on each side, at quadratically growing distances
    const auto &[assembled, fullTurn] = range;
    const double spacing = assembled.length() / (count - 1.0);
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        values.push_back(std::lerp(assembled.lower, assembled.upper, i / (count - 1.0)));
    }
    std::vector<double> ends{assembled.lower, assembled.upper};
    for (const double end : {fullTurn.lower, fullTurn.upper}) {
        if (!fullTurn.isEmpty() && assembled.contains(end)) {
            values.push_back(end);
            ends.push_back(end);
        }
    }
    for (const double end : ends) {
        for (int i = 1; i < kValuesBesideEnd; ++i) {
            const double distance = spacing * std::pow(static_cast<double>(i) / kValuesBesideEnd, 2);
            for (const double value : {end - distance, end + distance}) {
                if (assembled.contains(value)) {
                    values.push_back(value);
                }
            }
        }
    }
    std::ranges::sort(values);
    return values;
}

Response computeResponse(const Parameters &parameters, Parameter parameter, int count, const std::stop_token &stop)
{
    Response response{.parameters = parameters, .parameter = parameter, .range = responseRange(parameters, parameter)};
    response.values = responseValues(response.range, count);
    LimitValues noLimits;
    noLimits.fill(kNone);
    for (const double value : response.values) {
        Parameters varied = parameters;
        valueOf(varied, parameter) = value;
        const bool isUsable = !stop.stop_requested() && !findFault(varied);
        response.limits.push_back(isUsable ? limitValues(Mechanism(varied)) : noLimits);
    }
    return response;
}

} // namespace slidercrank
