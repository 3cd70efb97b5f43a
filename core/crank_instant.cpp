// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/crank_instant.h"

#include "core/channel.h"
#include "core/two_part_angle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slidercrank
{

std::optional<double> instantAtCrankAngle(const Mechanism &mechanism, double degrees, double start)
{
    constexpr double kTurn = 2.0 * std::numbers::pi;
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

} // namespace slidercrank
