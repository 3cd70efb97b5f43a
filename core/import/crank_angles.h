// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables over the crank angle instead of the time, as in textbooks and engine software. The time stamps follow from the
// drive:
//
//     t = (θ2 - θ20) / ω2
//
// Positions at a crank angle do not depend on the drive, but time derivatives do.

#include "core/import/reference_data.h"
#include "core/mechanism/mechanism.h"

#include <optional>
#include <vector>

namespace slidercrank
{

inline constexpr Channel kCrankAngle{Theta2, Order::Position};

/// Returns the angles of a table (°) before they were rounded, if these are whole or half degrees: a table in radians
/// usually has the angles 0°, 15°, 30° … Returns other angles unchanged, and angles with too few digits to tell.
std::vector<double> wholeDegreesBeforeRounding(std::vector<double> degrees, const Rounding &rounding);

/// Returns the data with the time stamps at which the crank of the mechanism has the angles of the file. Reverses the
/// order of the rows if the crank rotates in the opposite direction. Data with time stamps of their own are returned
/// unchanged. Returns nullopt if the crank stands still, or is so slow or fast that a double cannot distinguish the
/// time stamps.
std::optional<ReferenceData> timedBy(const Mechanism &mechanism, ReferenceData data);

} // namespace slidercrank
