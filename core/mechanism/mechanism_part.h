// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What of the mechanism an equation or a coordinate is about: the joint that a constraint stands for, the body that a
// coordinate moves.

#include "core/mechanism/mechanism.h"

namespace slidercrank
{

enum class MechanismPart {
    None,
    Ground,  ///< body 1, and what holds it
    Crank,   ///< body 2
    Coupler, ///< body 3
    Slider,  ///< body 4
    Pivot,   ///< revolute joint at O2
    PinA,    ///< revolute joint at A
    PinB,    ///< revolute joint at B
    Guide,   ///< prismatic joint: the slider on its line
    Drive    ///< what turns the crank
};

MechanismPart partOf(Constraint row);
MechanismPart partOf(Coordinate coordinate);

} // namespace slidercrank
