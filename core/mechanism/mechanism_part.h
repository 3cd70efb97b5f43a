// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Maps each constraint to its joint and each coordinate to its body, so that views can highlight them.

#include "core/mechanism/mechanism.h"

namespace slidercrank
{

enum class MechanismPart {
    None,
    Ground,  ///< body 1 and its constraints
    Crank,   ///< body 2
    Coupler, ///< body 3
    Slider,  ///< body 4
    Pivot,   ///< revolute joint at O2
    PinA,    ///< revolute joint at A
    PinB,    ///< revolute joint at B
    Guide,   ///< prismatic joint between slider and ground
    Drive    ///< the drive of the crank
};

MechanismPart partOf(Constraint row);
MechanismPart partOf(Coordinate coordinate);

} // namespace slidercrank
