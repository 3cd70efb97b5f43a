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

constexpr MechanismPart partOf(Constraint row)
{
    switch (row) {
    case GroundX:
    case GroundY:
    case GroundAngle: return MechanismPart::Ground;
    case CrankPivotX:
    case CrankPivotY: return MechanismPart::Pivot;
    case CrankPinX:
    case CrankPinY: return MechanismPart::PinA;
    case SliderPinX:
    case SliderPinY: return MechanismPart::PinB;
    case SliderAngle:
    case SliderLine: return MechanismPart::Guide;
    case CrankDrive: break;
    }
    return MechanismPart::Drive;
}

/// Returns the body: Ground, Crank, Coupler or Slider.
constexpr MechanismPart partOf(Coordinate coordinate)
{
    switch (coordinate) {
    case R1x:
    case R1y:
    case Theta1: return MechanismPart::Ground;
    case R2x:
    case R2y:
    case Theta2: return MechanismPart::Crank;
    case R3x:
    case R3y:
    case Theta3: return MechanismPart::Coupler;
    case R4x:
    case R4y:
    case Theta4: break;
    }
    return MechanismPart::Slider;
}

} // namespace slidercrank
