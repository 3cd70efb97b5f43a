// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/linkage_point.h"

#include "core/closed_form/state_at.h"

namespace slidercrank
{

LinkageMotion linkageMotion(const Mechanism &mechanism, double t)
{
    const State state = ClosedForm(mechanism).stateAt(t);
    const auto motionOf = [&state](Coordinate x, double factor) {
        const auto vectorOf = [&](const Vector12 &q) { return PlaneVector{factor * q[x], factor * q[x + 1]}; };
        return PointMotion{vectorOf(state.q), vectorOf(state.qDot), vectorOf(state.qDDot)};
    };
    return {motionOf(R2x, 2.0), motionOf(R4x, 1.0), motionOf(R3x, 1.0)}; // R2 is the midpoint of O2-A
}

} // namespace slidercrank
