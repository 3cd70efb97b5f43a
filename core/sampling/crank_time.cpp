// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sampling/crank_time.h"

#include "core/mechanism/turn.h"
#include "core/mechanism/two_part_angle.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

std::optional<double> timeAtCrankAngle(const Mechanism &mechanism, double theta2, double start)
{
    const double wanted = std::remainder(theta2, kTurn);
    const double angle = crankAngle(mechanism.omega2(), start, mechanism.theta20()).hi;

    // The same angle entered in degrees and in radians differs by rounding. Without the tolerance a difference in the
    // last digit would add a whole revolution.
    const double tolerance = 1e-12 + 4.0 * kEpsilon * std::abs(angle);

    if (mechanism.omega2() == 0.0) {
        const bool hasAngle = std::abs(std::remainder(angle - wanted, kTurn)) <= tolerance;
        return hasAngle ? std::optional(start) : std::nullopt;
    }
    const double direction = mechanism.omega2() > 0.0 ? 1.0 : -1.0;
    const double turns = std::ceil((direction * (angle - wanted) - tolerance) / kTurn);
    const double t = (wanted + direction * kTurn * turns - mechanism.theta20()) / mechanism.omega2();
    return std::isfinite(t) ? std::optional(std::max(t, start)) : std::nullopt;
}

double nearestTimeAtCrankAngle(const Mechanism &mechanism, const Sampling &sampling, double theta2, double t)
{
    const double omega2 = mechanism.omega2();
    if (omega2 == 0.0) {
        return t;
    }
    const double end = sampling.start + sampling.duration;
    const auto [first, last] = std::minmax({sampling.start, end});
    const auto angleTo = [&](double time) {
        return std::remainder(theta2 - crankAngle(omega2, time, mechanism.theta20()).hi, kTurn);
    };
    const double period = kTurn / std::abs(omega2);
    double passage = t + angleTo(t) / omega2; // the nearest one, which may be outside the time span
    if (passage < first) {
        passage += period;
    } else if (passage > last) {
        passage -= period;
    }
    if (passage >= first && passage <= last) {
        return passage;
    }
    return std::abs(angleTo(first)) < std::abs(angleTo(last)) ? first : last;
}

} // namespace slidercrank
