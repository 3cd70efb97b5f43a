// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/slider_stroke.h"

#include "core/closed_form/closed_form.h"
#include "core/mechanism/turn.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr double kAtAnEnd = 1e-9; // rad: closer than that to the end of a stroke is at it

/// The least of angle, angle ± 2π, … that is above the bound.
double firstAbove(double bound, double angle)
{
    const double turned = angle + kTurn * std::floor((bound - angle) / kTurn);
    return turned > bound ? turned : turned + kTurn;
}

double R4xAt(const Mechanism &mechanism, double theta2)
{
    return ClosedForm(withCrankAt(mechanism, theta2)).motionAt(0.0).R4x;
}

/// At the end of an arc the coupler is square to the slider's line; beyond it, by a rounding, there is no pose.
double sliderAt(const Mechanism &mechanism, double theta2)
{
    const double R4 = R4xAt(mechanism, theta2);
    return std::isnan(R4) ? mechanism.a() * std::cos(theta2) : R4;
}

} // namespace

std::optional<SliderStroke> strokeAround(const Mechanism &mechanism, const MotionLimits &limits, double theta2,
                                         int sense)
{
    const double inside = theta2 + sense * kAtAnEnd;
    double from = -std::numeric_limits<double>::infinity();
    double to = -from;
    const auto endAt = [&](double angle) {
        const double above = firstAbove(inside, angle);
        to = std::min(to, above);
        from = std::max(from, above - kTurn);
    };
    for (const std::optional<DeadCentre> &centre : {limits.outer, limits.inner}) {
        if (centre) {
            endAt(centre->theta2);
        }
    }
    if (limits.mobility != Mobility::FullTurn) {
        for (const CrankRange &range : limits.ranges) {
            endAt(range.from);
            endAt(range.to);
        }
    }
    if (!std::isfinite(from) || std::isnan(R4xAt(mechanism, 0.5 * (from + to)))) {
        return std::nullopt;
    }
    return SliderStroke{from, to, sliderAt(mechanism, from), sliderAt(mechanism, to)};
}

double crankAngleAt(const Mechanism &mechanism, const SliderStroke &stroke, double R4x)
{
    const double sense = stroke.R4xFrom < stroke.R4xTo ? 1.0 : -1.0;
    const double before = sense * (stroke.R4xFrom - R4x);
    const double behind = sense * (stroke.R4xTo - R4x);
    if (!(before < 0.0)) {
        return stroke.from;
    }
    if (!(behind > 0.0)) {
        return stroke.to;
    }
    const boost::math::tools::eps_tolerance<double> closeEnough;
    std::uintmax_t most = 100;
    const auto passed = [&](double theta2) { return sense * (sliderAt(mechanism, theta2) - R4x); };
    return boost::math::tools::toms748_solve(passed, stroke.from, stroke.to, before, behind, closeEnough, most).second;
}

} // namespace slidercrank
