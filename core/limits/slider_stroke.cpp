// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/slider_stroke.h"

#include "core/closed_form/closed_form.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace slidercrank
{

namespace
{

constexpr double kAtAnEnd =
    1e-9; // rad: an angle nearer than this to the end of a stroke is considered to be at the end

/// Returns the smallest of angle, angle ± 2π, … above the bound.
double firstAbove(double bound, double angle)
{
    const double turned = angle + kTurn * std::floor((bound - angle) / kTurn);
    return turned > bound ? turned : turned + kTurn;
}

/// Returns R4x at a crank angle, or NaN if the mechanism cannot be assembled.
double sliderAt(const Mechanism &mechanism, double theta2)
{
    return ClosedForm(withCrankAt(mechanism, theta2)).motionAt(0.0).R4x;
}

/// Returns R4x at the end of an arc, where the coupler is perpendicular to the slider's line and the mechanism may be
/// impossible to assemble because of rounding.
double sliderAtEnd(const Mechanism &mechanism, double theta2)
{
    const double R4x = sliderAt(mechanism, theta2);
    return std::isnan(R4x) ? mechanism.a() * std::cos(theta2) : R4x;
}

} // namespace

std::optional<SliderStroke> strokeAround(const Mechanism &mechanism, const MotionLimits &limits, double theta2,
                                         int sense)
{
    std::vector<double> ends;
    for (const std::optional<DeadCentre> &centre : {limits.outer, limits.inner}) {
        if (centre) {
            ends.push_back(centre->theta2);
        }
    }
    if (limits.mobility != Mobility::FullTurn) {
        for (const CrankRange &range : limits.ranges) {
            ends.insert(ends.end(), {range.from, range.to});
        }
    }
    const double inside = theta2 + sense * kAtAnEnd;
    double from = -std::numeric_limits<double>::infinity();
    double to = -from;
    for (const double end : ends) {
        const double above = firstAbove(inside, end);
        to = std::min(to, above);
        from = std::max(from, above - kTurn);
    }
    if (ends.empty() || std::isnan(sliderAt(mechanism, 0.5 * (from + to)))) {
        return std::nullopt;
    }
    return SliderStroke{from, to, sliderAtEnd(mechanism, from), sliderAtEnd(mechanism, to)};
}

double crankAngleAt(const Mechanism &mechanism, const SliderStroke &stroke, double R4x)
{
    if (R4x <= std::min(stroke.R4xFrom, stroke.R4xTo) || R4x >= std::max(stroke.R4xFrom, stroke.R4xTo)) {
        return std::abs(R4x - stroke.R4xFrom) < std::abs(R4x - stroke.R4xTo) ? stroke.from : stroke.to;
    }
    const bool rises = stroke.R4xFrom < stroke.R4xTo;
    double low = stroke.from;
    double high = stroke.to;
    for (double middle = std::midpoint(low, high); low < middle && middle < high; middle = std::midpoint(low, high)) {
        ((sliderAt(mechanism, middle) < R4x) == rises ? low : high) = middle;
    }
    return low;
}

} // namespace slidercrank
