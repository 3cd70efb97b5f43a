// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/coupler_angles.h"

#include "core/mechanism/turn.h"

#include <cmath>
#include <utility>

// With g = ±1, the sign of c, the angle φ = asin(g h/b) is θ3 for c >= 0 on the open branch. Here g h = C - a x varies
// between C - a (x = 1) and C + a (x = -1), unless the motion ends before, at g h = ±b. With √(b² - h²), which is
//
//     s = √(ε L) at g h = C + a        t = √(β γ) at g h = C - a
//
// the angle is φ = atan2(g h, √(b² - h²)), accurate also where it is near 90°. The transmission angle is 90° - |φ|.

namespace slidercrank
{

namespace
{

/// The extremes of φ.
struct Elevation {
    AngleExtreme maximum; ///< its magnitude is the largest one, too: |C - a| <= C + a
    AngleExtreme minimum;
    bool reachesBothEnds = false; ///< a rocker with two arcs, each of which leads from φ = -90° to φ = 90°
};

/// Returns the extremes of φ, with the crank angles at which they occur. `s` and `t`: the roots defined above.
Elevation elevationExtremes(const MotionConstants &k, double s, double t, const std::vector<CrankEnd> &ends)
{
    const double towardsOffset = k.side * kQuarterTurn; // the crank angle with x = 1
    const AngleExtreme smallest{std::atan2(k.C - k.a, t), {towardsOffset}};
    if (ends.empty()) { // full turns
        return {.maximum = {std::atan2(k.C + k.a, s), {-towardsOffset}}, .minimum = smallest};
    }
    // The coupler is perpendicular to the slider's line at the ends.
    Elevation elevation{.maximum = {.angle = kQuarterTurn}, .minimum = {.angle = -kQuarterTurn}};
    for (const CrankEnd &end : ends) {
        (end.isBeyondPin ? elevation.maximum : elevation.minimum).places.push_back(end.theta2);
    }
    elevation.reachesBothEnds = !elevation.minimum.places.empty();
    if (!elevation.reachesBothEnds) {
        elevation.minimum = smallest;
    }
    return elevation;
}

/// Returns the minimum of 90° - |φ|. It occurs at the largest φ, and also at the smallest φ if that has the same
/// magnitude. `s`: the root defined above.
AngleExtreme minimumTransmissionAngle(const MotionConstants &k, double s, bool isFullTurn, const Elevation &elevation)
{
    AngleExtreme minimum{isFullTurn ? std::atan2(s, k.C + k.a) : 0.0, elevation.maximum.places};
    const bool isSymmetric = isFullTurn ? k.C == 0.0 : elevation.reachesBothEnds;
    if (isSymmetric) {
        minimum.places.insert(minimum.places.end(), elevation.minimum.places.begin(), elevation.minimum.places.end());
    }
    return minimum;
}

/// Returns the maximum of 90° - |φ|. `t`: the root defined above.
AngleExtreme maximumTransmissionAngle(const MotionConstants &k, double t, const Elevation &elevation)
{
    if (k.C >= k.a) {
        return {std::atan2(t, k.C - k.a), elevation.minimum.places};
    }
    // The coupler becomes parallel to the slider's line, where a sin θ2 = c.
    const double theta2 = std::atan2(k.side * k.C, std::sqrt((k.a - k.C) * (k.a + k.C)));
    return {kQuarterTurn, {theta2, wrapToPi(std::numbers::pi - theta2)}};
}

/// Returns the difference of the extremes of φ without a difference of nearly equal numbers. `s` and `t`: the roots
/// defined above. For full turns
///
///     b² sin(swing) = (C + a) t - (C - a) s = 4a C²/(s + t) + a (s + t)        b² cos(swing) = s t + C² - a²
///
/// A rocker with one arc swings from φ = atan2(C - a, t) to 90°, one with two arcs from -90° to 90°.
double swing(const MotionConstants &k, double s, double t, bool isFullTurn, const Elevation &elevation)
{
    if (elevation.reachesBothEnds) {
        return std::numbers::pi;
    }
    if (!isFullTurn) {
        return std::atan2(t, k.C - k.a);
    }
    const double sum = s + t; // 0 only for a = b and c = 0
    const double sine = (k.C > 0.0 ? 4.0 * k.a * k.C * k.C / sum : 0.0) + k.a * sum;
    return std::atan2(sine, s * t + (k.C - k.a) * (k.C + k.a));
}

/// Returns the extreme of -φ, at the same crank angles.
AngleExtreme negative(AngleExtreme extreme)
{
    extreme.angle = -extreme.angle;
    return extreme;
}

/// Returns the extreme for the crossed assembly: the coupler angle becomes π - φ, at the same crank angles.
AngleExtreme forCrossedBranch(AngleExtreme extreme)
{
    extreme.angle = std::numbers::pi - extreme.angle;
    return extreme;
}

} // namespace

CouplerAngles couplerAngles(const MotionConstants &k, const std::vector<CrankEnd> &ends)
{
    const bool isFullTurn = ends.empty();
    const double s = isFullTurn ? std::sqrt(k.epsilon * k.reach) : 0.0;
    const double t = k.beta > 0.0 ? std::sqrt(k.betaGamma) : 0.0;
    Elevation elevation = elevationExtremes(k, s, t, ends);
    CouplerAngles angles;
    angles.minimumTransmissionAngle = minimumTransmissionAngle(k, s, isFullTurn, elevation);
    angles.maximumTransmissionAngle = maximumTransmissionAngle(k, t, elevation);
    angles.swing = swing(k, s, t, isFullTurn, elevation);
    if (k.side < 0.0) {
        elevation = {.maximum = negative(elevation.minimum), .minimum = negative(elevation.maximum)};
    }
    if (k.branch < 0.0) {
        elevation = {.maximum = forCrossedBranch(elevation.minimum), .minimum = forCrossedBranch(elevation.maximum)};
    }
    angles.maximumTheta3 = elevation.maximum;
    angles.minimumTheta3 = elevation.minimum;
    return angles;
}

} // namespace slidercrank
