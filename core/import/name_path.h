// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Splits a name that is a path, as programs write it.

#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// A name as a path whose last part is the quantity, and whose other parts may name the body:
///
///     slider.s   /crank_slider/slider/position   Latest: Position   Pos_TX@Slider   Position - Cart
struct NamePath {
    std::vector<std::string_view> parts{};
    std::string owner{};       ///< the parts before the last one, without those that only name a quantity
    bool isOfModelica = false; ///< "slider.s": a variable of Modelica's library
    bool isInSi = false;       ///< written by a program with m, rad and s, such as Modelica and ROS
};

/// Splits a name into the parts of its path. The parts refer to the name.
NamePath splitPath(std::string_view name);

} // namespace slidercrank
