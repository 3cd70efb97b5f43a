// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/linkage_point.h"

#include "core/closed_form/state_at.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

PlaneVector of(LinkagePoint point, const Vector12 &q)
{
    switch (point) {
    case LinkagePoint::A: return {2.0 * q[R2x], 2.0 * q[R2y]}; // the crank's centre of mass is the midpoint of O2-A
    case LinkagePoint::B: return {q[R4x], q[R4y]};
    case LinkagePoint::G3: return {q[R3x], q[R3y]};
    }
    return {};
}

} // namespace

LinkageMotion linkageMotion(const Mechanism &mechanism, double t)
{
    const State state = ClosedForm(mechanism).stateAt(t);
    LinkageMotion motion;
    std::ranges::transform(kLinkagePoints, motion.begin(), [&state](LinkagePoint point) {
        return PointMotion{of(point, state.q), of(point, state.qDot), of(point, state.qDDot)};
    });
    return motion;
}

} // namespace slidercrank
