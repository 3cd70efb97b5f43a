// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/mobility.h"

#include "core/closed_form/closed_form.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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
    if (mobility == Mobility::Impossible) {
        return {};
    }
    if (mobility == Mobility::FullTurn) {
        return {{-std::numbers::pi, std::numbers::pi}};
    }
    // asin((C - b)/a) from 1 + sin = -ε/a and 1 - sin = γ/a; asin((C + b)/a) likewise
    const double lowest = std::atan2(k.C - k.b, std::sqrt(-k.epsilon * k.gamma));
    std::vector<CrankRange> ranges{{lowest, std::numbers::pi - lowest}};
    if (k.beta < 0.0) {
        const double highest = std::atan2(k.C + k.b, std::sqrt(-k.beta * k.reach));
        ranges = {{lowest, highest}, {std::numbers::pi - highest, std::numbers::pi - lowest}};
    }
    for (CrankRange &range : ranges) {
        range = k.side > 0.0 ? normalized(range.from, range.to) : normalized(-range.to, -range.from);
    }
    std::ranges::sort(ranges, {}, &CrankRange::from);
    return ranges;
}

/// Returns a dead centre. `distance`: |R4x|, which is √(L γ) at the outer and √(ε β) at the inner dead centre.
SliderPosition deadCentre(const Mechanism &mechanism, double distance, bool isOuter)
{
    // If b >= a, the inner dead centre is on the same side of O2 as the outer one, and the crank points away from B.
    const bool pointsAway = !isOuter && mechanism.b() >= mechanism.a();
    const bool isRight = (mechanism.branch() == Branch::Open) == (isOuter || pointsAway);
    const double R4x = isRight ? distance : -distance;
    const double theta2 = pointsAway ? std::atan2(-mechanism.c(), -R4x) : std::atan2(mechanism.c(), R4x);
    return {wrapToPi(theta2), R4x};
}

/// Returns the positions at which the slider reverses: the dead centres and, of a rocker, the ends of its arcs. There
/// the coupler is perpendicular to the slider's line, so that R4x = a cos θ2.
std::vector<SliderPosition> findReversals(const Mechanism &mechanism, const MotionLimits &limits)
{
    std::vector<SliderPosition> reversals;
    for (const std::optional<SliderPosition> &centre : {limits.outer, limits.inner}) {
        if (centre) {
            reversals.push_back(*centre);
        }
    }
    for (const CrankRange &range : limits.ranges) {
        for (const double end : {range.from, range.to}) {
            if (limits.mobility != Mobility::FullTurn) {
                reversals.push_back({end, mechanism.a() * std::cos(end)});
            }
        }
    }
    return reversals;
}

/// Returns the stroke within a range.
double strokeWithin(const CrankRange &range, std::vector<SliderPosition> reversals)
{
    std::erase_if(reversals, [&range](const SliderPosition &place) { return !contains(range, place.theta2); });
    const auto [least, most] = std::ranges::minmax(reversals, {}, &SliderPosition::R4x);
    return most.R4x - least.R4x;
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
    const std::vector<SliderPosition> reversals = findReversals(mechanism, limits);
    for (const CrankRange &range : limits.ranges) {
        limits.stroke = std::max(limits.stroke.value_or(0.0), strokeWithin(range, reversals));
    }
    if (limits.mobility == Mobility::FullTurn) {
        const double counterClockwise = wrapToTwoPi(limits.outer->theta2 - limits.inner->theta2);
        const double outwards = mechanism.omega2() < 0.0 ? kTurn - counterClockwise : counterClockwise;
        limits.angleOutwards = outwards;
        limits.angleInwards = kTurn - outwards;
        limits.timeRatio = std::max(outwards, kTurn - outwards) / std::min(outwards, kTurn - outwards);
        limits.largestPressureAngle = std::atan2(k.a + k.C, std::sqrt(k.epsilon * k.reach));
        limits.largestPressureAngleAt = -k.side * kQuarterTurn;
    } else {
        limits.largestPressureAngle = kQuarterTurn;
        limits.largestPressureAngleAt = limits.ranges.front().from;
    }
    return limits;
}

std::vector<CrankRange> forbiddenRanges(const MotionLimits &limits)
{
    const std::vector<CrankRange> &ranges = limits.ranges;
    if (ranges.empty()) {
        return {{-std::numbers::pi, std::numbers::pi}};
    }
    std::vector<CrankRange> forbidden;
    for (std::size_t i = 0; i < ranges.size(); ++i) { // from the end of each to the start of the next
        const double next = i + 1 < ranges.size() ? ranges[i + 1].from : ranges[0].from + kTurn;
        if (ranges[i].to < next) {
            forbidden.push_back(normalized(ranges[i].to, next));
        }
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

std::optional<SliderStroke> strokeAround(const Mechanism &mechanism, const MotionLimits &limits, double theta2,
                                         int sense)
{
    constexpr double kAtAnEnd = 1e-9; // rad: an angle nearer than this to the end of a stroke is considered to be there
    const double inside = theta2 + sense * kAtAnEnd;
    std::vector<SliderPosition> ends = findReversals(mechanism, limits);
    if (ends.empty()) {
        return std::nullopt;
    }
    for (SliderPosition &end : ends) { // the next time that the crank passes it
        end.theta2 = inside + wrapToTwoPi(end.theta2 - inside);
    }
    auto [to, from] = std::ranges::minmax(ends, {}, &SliderPosition::theta2);
    from.theta2 -= kTurn;
    const auto containsMiddle = [middle = 0.5 * (from.theta2 + to.theta2)](const CrankRange &range) {
        return contains(range, middle);
    };
    return std::ranges::any_of(limits.ranges, containsMiddle) ? std::optional(SliderStroke{from, to}) : std::nullopt;
}

double crankAngleAt(const Mechanism &mechanism, const SliderStroke &stroke, double R4x)
{
    const auto &[from, to] = stroke;
    if (R4x <= std::min(from.R4x, to.R4x) || R4x >= std::max(from.R4x, to.R4x)) {
        return std::abs(R4x - from.R4x) < std::abs(R4x - to.R4x) ? from.theta2 : to.theta2;
    }
    double low = from.theta2;
    double high = to.theta2;
    for (double middle = std::midpoint(low, high); low < middle && middle < high; middle = std::midpoint(low, high)) {
        const Motion motion = ClosedForm(withCrankAt(mechanism, middle)).motionAt(0.0);
        ((motion.R4x < R4x) == (from.R4x < to.R4x) ? low : high) = middle;
    }
    return low;
}

} // namespace slidercrank
