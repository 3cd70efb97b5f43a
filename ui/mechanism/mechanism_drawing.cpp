// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_drawing.h"

#include "ui/mechanism/mechanism_frame.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

QPointF MechanismDrawing::crankPin() const
{
    const double a = mechanism().a();
    return {a * std::cos(pose.theta2), a * std::sin(pose.theta2)};
}

LinkageMotion MechanismDrawing::motion() const
{
    return linkageMotion(mechanism(), pose.time);
}

bool MechanismDrawing::hasCentre() const
{
    const bool wanted = settings.velocity || settings.acceleration || settings.path || settings.names;
    return wanted && pins && pose.exists();
}

void MechanismDrawing::refreshCycle(const QRectF &frame)
{
    cycle.clear();
    if (!result || !(settings.showsVelocity() || settings.acceleration || settings.path)) {
        return;
    }
    constexpr double kLongest = 0.4; // of the mechanism's extent
    const QRectF reach = characteristicLength(mechanism(), result->limits);
    const double longest = kLongest * std::max(reach.width(), reach.height());
    cycle = cycleOf(mechanism(), result->limits);
    velocity = arrowScale(cycle, MotionKind::Velocity, mechanism(), frame, longest);
    acceleration = arrowScale(cycle, MotionKind::Acceleration, mechanism(), frame, longest);
}

} // namespace slidercrank
