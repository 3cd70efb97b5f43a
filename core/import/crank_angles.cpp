// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/crank_angles.h"

#include "core/import/clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

std::vector<double> wholeDegreesBeforeRounding(std::vector<double> degrees, const Rounding &rounding)
{
    constexpr double kHalfDegree = 0.5;
    constexpr double kMaxHalfStep = 0.1 * kHalfDegree; // with larger rounding errors, any angle may have been whole
    constexpr double kTieFactor = 1.0 + 1e-6; // an angle in the middle of two printable ones is not exact in binary
    std::vector<double> whole = degrees;
    for (double &angle : whole) {
        const double halfStep = 0.5 * rounding.stepAt(angle);
        const double nearest = kHalfDegree * std::round(angle / kHalfDegree);
        if (!(halfStep <= kMaxHalfStep && std::abs(nearest - angle) <= kTieFactor * halfStep)) {
            return degrees;
        }
        angle = nearest;
    }
    return whole;
}

std::optional<ReferenceData> timedBy(const Mechanism &mechanism, ReferenceData data)
{
    if (!data.crank) {
        return data;
    }
    CrankAngles &crank = *data.crank;
    const double theta20 = mechanism.theta20() * kDegreesPerRadian; // °
    const double omega2 = mechanism.omega2() * kDegreesPerRadian;   // °/s
    const bool rises = crank.degrees.back() >= crank.degrees.front();
    if (rises != (omega2 > 0.0)) {
        std::ranges::reverse(crank.degrees);
        std::ranges::reverse(data.lines);
        for (ReferenceSeries &series : data.series) {
            std::ranges::reverse(series.values);
        }
    }
    crank.omega2 = mechanism.omega2();
    crank.theta20 = mechanism.theta20();
    data.time.resize(crank.degrees.size());
    std::ranges::transform(crank.degrees, data.time.begin(), [&](double angle) { return (angle - theta20) / omega2; });
    data.timeRounding = crank.rounding.withDecimalsAt(rangeOf(crank.degrees).size());
    data.timeRounding.unitFactor /= std::abs(omega2);
    if (timePrecisionOf(data.time, data.timeRounding).isEven) {
        data.timeRounding = Rounding(); // evenly spaced angles were chosen, not measured, and are exact
    }
    const bool areDistinct =
        std::isfinite(data.time.front()) && std::isfinite(data.time.back()) && !findReversal(data.time);
    return areDistinct ? std::optional(std::move(data)) : std::nullopt;
}

} // namespace slidercrank
