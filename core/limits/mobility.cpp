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
    if (k.gamma < 0.0) {
        return Mobility::Impossible;
    }
    if (k.epsilon >= 0.0) {
        return Mobility::FullTurn;
    }
    return k.gamma == 0.0 ? Mobility::Locked : Mobility::Rocker;
}

/// Returns the range with `from` wrapped to [-π, π).
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
    // asin((C - b)/a), whose cosine follows from 1 + sin = -ε/a and 1 - sin = γ/a; asin((C + b)/a) likewise
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

enum class DeadCentre { Outer, Inner };

/// `distance`: |R4x|, which is √(L γ) at the outer and √(ε β) at the inner dead centre.
SliderPosition deadCentrePosition(DeadCentre deadCentre, const Mechanism &mechanism, double distance)
{
    const bool isOuter = deadCentre == DeadCentre::Outer;
    // If b >= a, the inner dead centre is on the same side of O2 as the outer one, and the crank points away from B.
    const bool pointsAway = !isOuter && mechanism.b() >= mechanism.a();
    const bool isRight = (mechanism.branch() == Branch::Open) == (isOuter || pointsAway);
    const double R4x = isRight ? distance : -distance;
    const double theta2 = pointsAway ? std::atan2(-mechanism.c(), -R4x) : std::atan2(mechanism.c(), R4x);
    return {.theta2 = wrapToPi(theta2), .R4x = R4x};
}

/// Returns the ends of the ranges, once each. With x = sin θ2 (-sin θ2 for c < 0), the ends are at x = (C - b)/a, where
/// ArcEnd::isBOnOffsetSide is true, and if there are two arcs also at x = (C + b)/a. Whether x rises along
/// an arc decides which of the two an end is. The value of x at the end does not, because with a very short coupler the
/// two are equal except for rounding.
std::vector<ArcEnd> findArcEnds(const MotionConstants &k, Mobility mobility, const std::vector<CrankRange> &ranges)
{
    std::vector<ArcEnd> ends;
    for (const CrankRange &range : mobility == Mobility::FullTurn ? std::vector<CrankRange>() : ranges) {
        const bool hasOneArc = k.beta >= 0.0;
        const bool rises = k.side * std::cos(0.5 * (range.from + range.to)) > 0.0;
        ends.push_back({.theta2 = wrapToPi(range.from), .isBOnOffsetSide = hasOneArc || rises});
        ends.push_back({.theta2 = wrapToPi(range.to), .isBOnOffsetSide = hasOneArc || !rises});
    }
    if (mobility == Mobility::Locked) {
        ends.pop_back(); // both ends are the same position
    }
    return ends;
}

/// Returns the positions at the ends of the ranges. There the coupler is perpendicular to the slider's line, so that
/// R4x = a cos θ2. With the sums of lengths of motion_constants.h, a |cos θ2| is √(-ε γ) where ArcEnd::isBOnOffsetSide
/// is true, and √(-β L) at the other ends.
std::vector<SliderPosition> findCrankLimits(const MotionConstants &k, const std::vector<ArcEnd> &ends)
{
    std::vector<SliderPosition> limits;
    for (const ArcEnd &end : ends) {
        const double distance = std::sqrt(end.isBOnOffsetSide ? -k.epsilon * k.gamma : -k.beta * k.reach);
        limits.push_back({.theta2 = end.theta2, .R4x = std::copysign(distance, std::cos(end.theta2))});
    }
    return limits;
}

/// Returns the positions at which the slider reverses: the dead centres and, of a rocker, the ends of its arcs.
std::vector<SliderPosition> findReversals(const MotionLimits &limits)
{
    std::vector<SliderPosition> reversals = limits.crankLimits;
    for (const std::optional<SliderPosition> &centre : {limits.outerDeadCentre, limits.innerDeadCentre}) {
        if (centre) {
            reversals.push_back(*centre);
        }
    }
    return reversals;
}

/// Returns the stroke without a difference of nearly equal numbers. With D = √(L γ) and I = √(ε β), the distances of
/// the dead centres, and e = √(-ε γ), f = √(-β L), those of the ends of the arcs:
///
///     full turn   D - I = (L γ - ε β) / (D + I) = 4ab / (D + I)
///     one arc     D + e, from an end on one side of O2 to the outer dead centre on the other
///     two arcs    D - f = L (γ + β) / (D + f) = 2bL / (D + f) in the arc with the outer dead centre. It is larger
///                 than e - I, the stroke in the other arc, because (D + I)² - (e + f)² = 4b²
double findStroke(const MotionConstants &k, Mobility mobility)
{
    const double outer = std::sqrt(k.reach * k.gamma);
    if (mobility == Mobility::FullTurn) {
        return 4.0 * k.a * k.b / (outer + std::sqrt(k.epsilon * k.beta));
    }
    return k.beta >= 0.0 ? outer + std::sqrt(-k.epsilon * k.gamma)
                         : 2.0 * k.b * k.reach / (outer + std::sqrt(-k.beta * k.reach));
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
    limits.outerDeadCentre = deadCentrePosition(DeadCentre::Outer, mechanism, std::sqrt(k.reach * k.gamma));
    if (k.epsilon * k.beta >= 0.0) {
        limits.innerDeadCentre = deadCentrePosition(DeadCentre::Inner, mechanism, std::sqrt(k.epsilon * k.beta));
    }
    const std::vector<ArcEnd> ends = findArcEnds(k, limits.mobility, limits.ranges);
    limits.crankLimits = findCrankLimits(k, ends);
    limits.stroke = findStroke(k, limits.mobility);
    limits.coupler = couplerAngles(k, ends);
    if (limits.mobility == Mobility::FullTurn) {
        const double counterClockwise = wrapToTwoPi(limits.outerDeadCentre->theta2 - limits.innerDeadCentre->theta2);
        const double outwards = mechanism.omega2() < 0.0 ? kTurn - counterClockwise : counterClockwise;
        limits.angleOutwards = outwards;
        limits.angleInwards = kTurn - outwards;
        limits.timeRatio = std::max(outwards, kTurn - outwards) / std::min(outwards, kTurn - outwards);
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
    for (std::size_t i = 0; i < ranges.size(); ++i) { // from the end of each range to the start of the next
        const double next = i + 1 < ranges.size() ? ranges[i + 1].from : ranges.front().from + kTurn;
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

std::optional<SliderStroke> strokeAround(const MotionLimits &limits, double theta2, CrankDirection direction)
{
    constexpr double kEndTolerance = 1e-9; // rad: an angle this near to the end of a stroke is considered to be there
    const double inside =
        direction == CrankDirection::CounterClockwise ? theta2 + kEndTolerance : theta2 - kEndTolerance;
    std::vector<SliderPosition> reversals = findReversals(limits);
    if (reversals.empty()) {
        return std::nullopt;
    }
    for (SliderPosition &reversal : reversals) { // within the revolution that begins at `inside`
        reversal.theta2 = inside + wrapToTwoPi(reversal.theta2 - inside);
    }
    auto [to, from] = std::ranges::minmax(reversals, {}, &SliderPosition::theta2); // the first and the last one
    from.theta2 -= kTurn; // a revolution earlier, before `inside`
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

bool velocitiesJumpAt(const Mechanism &mechanism, double theta2)
{
    constexpr double kMaxCosine = 1e-9; // |cos θ2| up to it counts as 0: no double is exactly 90°
    const double side = mechanism.c() == 0.0 ? 0.0 : std::copysign(1.0, mechanism.c());
    return mechanism.b() == shortestCouplerForFullTurn(mechanism) && std::abs(std::cos(theta2)) <= kMaxCosine &&
           side * std::sin(theta2) <= 0.0;
}

} // namespace slidercrank
