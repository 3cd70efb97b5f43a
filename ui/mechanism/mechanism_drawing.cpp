// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_drawing.h"

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

} // namespace slidercrank
