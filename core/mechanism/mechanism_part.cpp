// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism/mechanism_part.h"

namespace slidercrank
{

MechanismPart partOf(Constraint row)
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
    case CrankDrive: return MechanismPart::Drive;
    }
    return MechanismPart::None;
}

MechanismPart partOf(Coordinate coordinate)
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
    case Theta4: return MechanismPart::Slider;
    }
    return MechanismPart::None;
}

} // namespace slidercrank
