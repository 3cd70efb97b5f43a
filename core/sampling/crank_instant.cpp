// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sampling/crank_instant.h"

#include "core/mechanism/channel.h"
#include "core/mechanism/turn.h"
#include "core/mechanism/two_part_angle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

std::optional<double> instantAtCrankAngle(const Mechanism &mechanism, double degrees, double start)
{
    const double wanted = std::remainder(degrees, 360.0) / kDegreesPerRadian;
    const double angle = crankAngle(mechanism.omega2(), start, mechanism.theta20()).hi;

    // An angle typed in degrees and one typed in radians are the same within their roundings; without this allowance
    // the crank would be sent once round for a difference in the last digit.
    const double same = 1e-12 + 4.0 * std::numeric_limits<double>::epsilon() * std::abs(angle);

    if (mechanism.omega2() == 0.0) {
        const bool there = std::abs(std::remainder(angle - wanted, kTurn)) <= same;
        return there ? std::optional(start) : std::nullopt;
    }
    const double direction = mechanism.omega2() > 0.0 ? 1.0 : -1.0;
    const double turns = std::ceil((direction * (angle - wanted) - same) / kTurn);
    const double instant = (wanted + direction * kTurn * turns - mechanism.theta20()) / mechanism.omega2();
    if (!std::isfinite(instant)) {
        return std::nullopt;
    }
    return std::max(instant, start);
}

double nearestInstantAtCrankAngle(const Mechanism &mechanism, const Sampling &run, double theta2, double t)
{
    const double omega2 = mechanism.omega2();
    if (omega2 == 0.0) {
        return t;
    }
    const double first = std::min(run.start, run.start + run.duration);
    const double last = std::max(run.start, run.start + run.duration);
    const auto farness = [&](double instant) {
        return std::remainder(theta2 - crankAngle(omega2, instant, mechanism.theta20()).hi, kTurn);
    };
    const double wanted = t + farness(t) / omega2;
    if (wanted >= first && wanted <= last) {
        return wanted;
    }
    const double period = kTurn / std::abs(omega2);
    const double turns = wanted < first ? std::ceil((first - wanted) / period) : -std::ceil((wanted - last) / period);
    const double turned = wanted + turns * period;
    if (turned >= first && turned <= last) {
        return turned;
    }
    return std::abs(farness(first)) < std::abs(farness(last)) ? first : last;
}

} // namespace slidercrank
