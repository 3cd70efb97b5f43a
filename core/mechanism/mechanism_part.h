// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Maps each constraint to its joint and each coordinate to its body, so that views can highlight them.

#include "core/mechanism/mechanism.h"

#include <array>

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
    using enum MechanismPart;
    constexpr std::array kParts{Ground, Ground, Ground, Pivot, Pivot, PinA, PinA, PinB, PinB, Guide, Guide, Drive};
    return kParts[static_cast<std::size_t>(row)];
}

/// Returns the body: Ground, Crank, Coupler or Slider.
constexpr MechanismPart partOf(Coordinate coordinate)
{
    return static_cast<MechanismPart>(coordinate / 3 + static_cast<int>(MechanismPart::Ground));
}

} // namespace slidercrank
