// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/coupler_angles.h"

#include "core/mechanism/turn.h"

#include <cmath>
#include <utility>

// With the names of motion_constants.h, the elevation φ = asin(g h/b) of the coupler is θ3 for c >= 0 on the open
// branch. g h = C - a x varies between C - a (x = 1) and C + a (x = -1), unless the motion of a rocker ends before, at
// g h = ±b. φ = atan2(g h, √(b² - h²)) is accurate also near 90°. The root is
//
//     s = √(ε L) at g h = C + a        t = √(β γ) at g h = C - a
//
// The transmission angle is 90° - |φ|.

namespace slidercrank
{

namespace
{

/// The extremes of φ.
struct ElevationExtremes {
    AngleExtreme maximum; ///< also the largest |φ|, because |C - a| <= C + a
    AngleExtreme minimum;
    bool reachesBothEnds = false; ///< a rocker with two arcs, each of which leads from φ = -90° to φ = 90°
};

/// Returns the extremes of φ, with the crank angles at which they occur. `s` and `t`: the roots defined above.
ElevationExtremes elevationExtremes(const MotionConstants &k, double s, double t, const std::vector<ArcEnd> &ends)
{
    const double towardsOffset = k.side * kQuarterTurn; // the crank angle with x = 1
    const AngleExtreme smallest{std::atan2(k.C - k.a, t), {towardsOffset}};
    if (ends.empty()) { // full turns
        return {.maximum = {std::atan2(k.C + k.a, s), {-towardsOffset}}, .minimum = smallest};
    }
    // The coupler is perpendicular to the slider's line at the ends.
    ElevationExtremes elevation{.maximum = {.angle = kQuarterTurn}, .minimum = {.angle = -kQuarterTurn}};
    for (const ArcEnd &end : ends) {
        (end.isBOnOffsetSide ? elevation.maximum : elevation.minimum).crankAngles.push_back(end.theta2);
    }
    elevation.reachesBothEnds = !elevation.minimum.crankAngles.empty();
    if (!elevation.reachesBothEnds) {
        elevation.minimum = smallest;
    }
    return elevation;
}

/// Returns the minimum of 90° - |φ|. It occurs at the largest φ, and also at the smallest φ if that has the same
/// magnitude. `s`: the root defined above.
AngleExtreme minimumTransmissionAngle(const MotionConstants &k, double s, bool isFullTurn,
                                      const ElevationExtremes &elevation)
{
    AngleExtreme minimum{isFullTurn ? std::atan2(s, k.C + k.a) : 0.0, elevation.maximum.crankAngles};
    const bool isSymmetric = isFullTurn ? k.C == 0.0 : elevation.reachesBothEnds;
    if (isSymmetric) {
        minimum.crankAngles.insert(minimum.crankAngles.end(), elevation.minimum.crankAngles.begin(),
                                   elevation.minimum.crankAngles.end());
    }
    return minimum;
}

/// Returns the maximum of 90° - |φ|. `t`: the root defined above.
AngleExtreme maximumTransmissionAngle(const MotionConstants &k, double t, const ElevationExtremes &elevation)
{
    if (k.C >= k.a) {
        return {std::atan2(t, k.C - k.a), elevation.minimum.crankAngles};
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
double swing(const MotionConstants &k, double s, double t, bool isFullTurn, const ElevationExtremes &elevation)
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

CouplerAngles couplerAngles(const MotionConstants &k, const std::vector<ArcEnd> &ends)
{
    const bool isFullTurn = ends.empty();
    const double s = isFullTurn ? std::sqrt(k.epsilon * k.reach) : 0.0;
    const double t = k.beta > 0.0 ? std::sqrt(k.betaGamma) : 0.0;
    ElevationExtremes elevation = elevationExtremes(k, s, t, ends);
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
