// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Short names of the channels that many tests use.

#include "core/mechanism/channel.h"

namespace slidercrank
{

inline constexpr Channel kTheta2{Theta2, Order::Position};
inline constexpr Channel kTheta3{Theta3, Order::Position};
inline constexpr Channel kTheta3Speed{Theta3, Order::Velocity};
inline constexpr Channel kTheta3Acceleration{Theta3, Order::Acceleration};
inline constexpr Channel kSlider{R4x, Order::Position};
inline constexpr Channel kSliderSpeed{R4x, Order::Velocity};
inline constexpr Channel kSliderAcceleration{R4x, Order::Acceleration};

} // namespace slidercrank
