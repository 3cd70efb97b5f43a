// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/mobility.h"

#include "core/closed_form/motion_constants.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

bool contains(const CrankRange &range, double angle)
{
    constexpr double kSlack = 1e-12; // rad: a dead centre at the end of a range belongs to it
    return wrapToTwoPi(angle - range.from + kSlack) <= range.to - range.from + 2.0 * kSlack;
}

Mobility classify(const MotionConstants &k)
{
    return k.gamma < 0.0      ? Mobility::Impossible
           : k.epsilon >= 0.0 ? Mobility::FullTurn
           : k.gamma == 0.0   ? Mobility::Locked
                              : Mobility::Rocker;
}

CrankRange normalized(double from, double to)
{
    const double start = wrapToPi(from);
    return {start, start + (to - from)};
}

/// Returns the ranges in which the mechanism can be assembled. For c >= 0: sin θ2 >= (c - b)/a, and sin θ2 <= (c + b)/a
/// if that is below 1. Mirrored for c < 0.
std::vector<CrankRange> findRanges(Mobility mobility, const MotionConstants &k)
{
    std::vector<CrankRange> ranges;
    switch (mobility) {
    case Mobility::Impossible: return ranges;
    case Mobility::FullTurn: return {{-std::numbers::pi, std::numbers::pi}};
    case Mobility::Locked: ranges = {{kQuarterTurn, kQuarterTurn}}; break;
    case Mobility::Rocker: {
        // asin((C - b)/a) from 1 + sin = -ε/a and 1 - sin = γ/a; asin((C + b)/a) likewise
        const double lowest = std::atan2(k.C - k.b, std::sqrt(-k.epsilon * k.gamma));
        if (k.beta < 0.0) {
            const double highest = std::atan2(k.C + k.b, std::sqrt(-k.beta * k.reach));
            ranges = {{lowest, highest}, {std::numbers::pi - highest, std::numbers::pi - lowest}};
        } else {
            ranges = {{lowest, std::numbers::pi - lowest}};
        }
        break;
    }
    }
    for (CrankRange &range : ranges) {
        range = k.side > 0.0 ? normalized(range.from, range.to) : normalized(-range.to, -range.from);
    }
    std::sort(ranges.begin(), ranges.end(), [](const CrankRange &x, const CrankRange &y) { return x.from < y.from; });
    return ranges;
}

/// Returns a dead centre. `distance`: |R4x|, which is √(L γ) at the outer and √(ε β) at the inner dead centre.
DeadCentre deadCentre(const Mechanism &mechanism, double distance, bool isOuter)
{
    // If b >= a, the inner dead centre is on the same side of O2 as the outer one, and the crank points away from B.
    const bool pointsAway = !isOuter && mechanism.b() >= mechanism.a();
    const bool isRight = (mechanism.branch() == Branch::Open) == (isOuter || pointsAway);
    const double R4x = isRight ? distance : -distance;
    const double theta2 = pointsAway ? std::atan2(-mechanism.c(), -R4x) : std::atan2(mechanism.c(), R4x);
    return {wrapToPi(theta2), R4x};
}

/// Returns the stroke within a range. R4x is extreme at dead centres and at the ends of the arc of a rocker, where the
/// coupler is perpendicular to the slider's line, so that R4x = a cos θ2.
double strokeWithin(const CrankRange &range, const Mechanism &mechanism, const MotionLimits &limits)
{
    double smallest = mechanism.a() * std::cos(range.from);
    double largest = smallest;
    const auto include = [&](double R4x) {
        smallest = std::min(smallest, R4x);
        largest = std::max(largest, R4x);
    };
    include(mechanism.a() * std::cos(range.to));
    for (const std::optional<DeadCentre> &centre : {limits.outer, limits.inner}) {
        if (centre && contains(range, centre->theta2)) {
            include(centre->R4x);
        }
    }
    return largest - smallest;
}

} // namespace

MotionLimits motionLimits(const Mechanism &mechanism)
{
    const MotionConstants k(mechanism);
    MotionLimits limits;
    limits.mobility = classify(k);
    limits.ranges = findRanges(limits.mobility, k);
    if (limits.mobility == Mobility::Impossible) {
        return limits;
    }
    limits.outer = deadCentre(mechanism, std::sqrt(k.reach * k.gamma), true);
    if (k.epsilon * k.beta >= 0.0) {
        limits.inner = deadCentre(mechanism, std::sqrt(k.epsilon * k.beta), false);
    }
    if (limits.mobility == Mobility::FullTurn) {
        limits.stroke = std::abs(limits.outer->R4x - limits.inner->R4x);
        const double counterClockwise = wrapToTwoPi(limits.outer->theta2 - limits.inner->theta2);
        const double outwards = mechanism.omega2() < 0.0 ? kTurn - counterClockwise : counterClockwise;
        limits.angleOutwards = outwards;
        limits.angleInwards = kTurn - outwards;
        limits.timeRatio = std::max(outwards, kTurn - outwards) / std::min(outwards, kTurn - outwards);
        limits.largestPressureAngle = std::atan2(k.a + k.C, std::sqrt(k.epsilon * k.reach));
        limits.largestPressureAngleAt = -k.side * kQuarterTurn;
        return limits;
    }
    for (const CrankRange &range : limits.ranges) {
        limits.stroke = std::max(limits.stroke.value_or(0.0), strokeWithin(range, mechanism, limits));
    }
    limits.largestPressureAngle = kQuarterTurn;
    limits.largestPressureAngleAt = limits.ranges.front().from;
    return limits;
}

std::vector<CrankRange> forbiddenRanges(const MotionLimits &limits)
{
    switch (limits.mobility) {
    case Mobility::FullTurn: return {};
    case Mobility::Impossible: return {{-std::numbers::pi, std::numbers::pi}};
    case Mobility::Rocker:
    case Mobility::Locked: break;
    }
    std::vector<CrankRange> forbidden;
    for (std::size_t i = 0; i < limits.ranges.size(); ++i) { // from the end of each to the start of the next
        const bool last = i + 1 == limits.ranges.size();
        forbidden.push_back(
            normalized(limits.ranges[i].to, last ? limits.ranges[0].from + kTurn : limits.ranges[i + 1].from));
    }
    return forbidden;
}

std::vector<double> anglesAcross(const CrankRange &range, int steps)
{
    const double middle = 0.5 * (range.from + range.to);
    const double half = 0.5 * (range.to - range.from);
    std::vector<double> angles;
    for (int i = 0; i <= steps; ++i) {
        angles.push_back(middle - half * std::cos(std::numbers::pi * i / steps));
    }
    return angles;
}

double shortestCouplerForAnyPose(const Mechanism &mechanism)
{
    return std::abs(mechanism.c()) - mechanism.a();
}

double shortestCouplerForFullTurn(const Mechanism &mechanism)
{
    return mechanism.a() + std::abs(mechanism.c());
}

double longestCrankForFullTurn(const Mechanism &mechanism)
{
    return mechanism.b() - std::abs(mechanism.c());
}

double largestOffsetForFullTurn(const Mechanism &mechanism)
{
    return mechanism.b() - mechanism.a();
}

} // namespace slidercrank
