// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/response.h"

#include "core/limits/extremes.h"
#include "core/limits/mobility.h"
#include "ui/text/finding_text.h"
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
    const MotionLimits limits = motionLimits(mechanism);
    LimitValues values{limits.stroke.value_or(kNone), limits.timeRatio.value_or(kNone), kNone, kNone, kNone};
    if (limits.mobility != Mobility::FullTurn) {
        return values;
    }
    values[2] = 90.0 - kDegreesPerRadian * limits.largestPressureAngle;
    for (const Peak &peak : motionPeaks(mechanism)) {
        if (peak.channel.coordinate == R4x) {
            values[peak.channel.order == Order::Velocity ? kFirstPeak : kFirstPeak + 1] =
                std::isfinite(peak.magnitude) ? peak.magnitude : kNone;
        }
    }
    return values;
}

ResponseRange responseRange(const Parameters &parameters, Parameter parameter)
{
    const auto &[a, b, offset, omega2, theta20, branch] = parameters;
    const double c = std::abs(offset);
    const double value = valueOf(parameters, parameter);
    const auto upTo = [value](double end) { return std::min(std::max(end, 1.25 * value), kLargestParameter); };
    Interval assembled;
    Interval fullTurn;
    switch (parameter) {
    case Parameter::A:
        assembled = {std::max(kShortestLink, c - b), upTo(b > c ? 1.5 * (b - c) : 2.0 * (b + c))};
        fullTurn = {assembled.lower, b - c};
        break;
    case Parameter::B:
        assembled = {std::max(kShortestLink, c - a), upTo(3.0 * (a + c))};
        fullTurn = {a + c, kLargestParameter};
        break;
    case Parameter::C:
        assembled = {-(a + b), a + b};
        fullTurn = {a - b, b - a};
        break;
    case Parameter::Omega2:
    case Parameter::Theta20: {
        const double end = nextRoundNumber(std::max(1.25 * std::abs(value), 1.0));
        assembled = {-end, end};
        fullTurn = b >= a + c ? assembled : Interval{1.0, -1.0};
        break;
    }
    }
    return {assembled, fullTurn};
}

QString fullTurnText(Parameter parameter, const ResponseRange &range)
{
    const auto &[lower, upper] = range.fullTurn;
    const bool hasLower = lower > range.assembled.lower;
    const bool hasUpper = upper < range.assembled.upper;
    const QString symbol = symbolText(parameter);
    return lower > upper          ? ResponseText::tr("The crank makes full turns for no value of %1.").arg(symbol)
           : hasLower && hasUpper ? ResponseText::tr("Full turns for %1 ≤ %2 ≤ %3 mm, shaded elsewhere.")
                                        .arg(numberText(lower), symbol, numberText(upper))
           : hasLower ? ResponseText::tr("Full turns for %1 ≥ %2 mm, shaded elsewhere.").arg(symbol, numberText(lower))
           : hasUpper ? ResponseText::tr("Full turns for %1 ≤ %2 mm, shaded elsewhere.").arg(symbol, numberText(upper))
                      : QString();
}

Response computeResponse(const Parameters &parameters, Parameter parameter, int count, const std::stop_token &stop)
{
    Response response{parameters, parameter, responseRange(parameters, parameter)};
    const auto &[assembled, fullTurn] = response.range;
    for (int i = 0; i < count; ++i) {
        response.values.push_back(std::lerp(assembled.lower, assembled.upper, i / (count - 1.0)));
    }
    for (const double end : {fullTurn.lower, fullTurn.upper}) {
        if (fullTurn.length() >= 0.0 && assembled.contains(end)) {
            response.values.push_back(end);
        }
    }
    std::ranges::sort(response.values);
    for (const double value : response.values) {
        Parameters varied = parameters;
        valueOf(varied, parameter) = value;
        const bool isUsable = !stop.stop_requested() && !findFault(varied);
        response.limits.push_back(isUsable ? limitValues(Mechanism(varied))
                                           : LimitValues{kNone, kNone, kNone, kNone, kNone});
    }
    return response;
}

} // namespace slidercrank
