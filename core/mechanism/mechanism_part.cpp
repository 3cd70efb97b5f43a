// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism/mechanism_part.h"

#include <array>

namespace slidercrank
{

MechanismPart partOf(Constraint row)
{
    using enum MechanismPart;
    constexpr std::array kParts{Ground, Ground, Ground, Pivot, Pivot, PinA, PinA, PinB, PinB, Guide, Guide, Drive};
    return kParts[static_cast<std::size_t>(row)];
}

MechanismPart partOf(Coordinate coordinate)
{
    using enum MechanismPart;
    constexpr std::array kBodies{Ground, Crank, Coupler, Slider};
    return kBodies[static_cast<std::size_t>(coordinate) / 3];
}

} // namespace slidercrank
