// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/linkage_point.h"

#include "core/closed_form/state_at.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

/// The coordinate that is proportional to x of a point; the next one is to y.
struct PointCoordinates {
    Coordinate x;
    double factor;
};

/// In the order of kLinkagePoints. The crank's centre of mass is the midpoint of O2-A.
constexpr std::array<PointCoordinates, kLinkagePoints.size()> kCoordinates{{{R2x, 2.0}, {R4x, 1.0}, {R3x, 1.0}}};

} // namespace

LinkageMotion linkageMotion(const Mechanism &mechanism, double t)
{
    const State state = ClosedForm(mechanism).stateAt(t);
    LinkageMotion motion;
    std::ranges::transform(kCoordinates, motion.begin(), [&state](PointCoordinates point) {
        const auto vectorOf = [point](const Vector12 &q) {
            return PlaneVector{point.factor * q[point.x], point.factor * q[point.x + 1]};
        };
        return PointMotion{vectorOf(state.q), vectorOf(state.qDot), vectorOf(state.qDDot)};
    });
    return motion;
}

} // namespace slidercrank
