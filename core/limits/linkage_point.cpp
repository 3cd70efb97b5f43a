// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/linkage_point.h"

#include "core/closed_form/closed_form.h"

#include <cmath>

namespace slidercrank
{

namespace
{

Eigen::Vector2d of(LinkagePoint point, const Vector12 &q)
{
    switch (point) {
    case LinkagePoint::A: return 2.0 * Eigen::Vector2d(q[R2x], q[R2y]); // the crank's centre of mass lies half way
    case LinkagePoint::B: return {q[R4x], q[R4y]};
    case LinkagePoint::G3: return {q[R3x], q[R3y]};
    }
    return {};
}

} // namespace

PointMotion motionOf(LinkagePoint point, const State &state)
{
    return {of(point, state.q), of(point, state.qDot), of(point, state.qDDot)};
}

State stateAtCrankAngle(const Mechanism &mechanism, double theta2)
{
    Parameters parameters = mechanism.parameters();
    parameters.theta20 = theta2;
    return ClosedForm(Mechanism(parameters)).stateAt(0.0);
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

} // namespace slidercrank
