// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Recognizes velocities and accelerations that are difference quotients of neighbouring rows. They approximate the
// derivative half a step away, and from positions with few digits they are mostly rounding errors.

#include "core/import/file_layout.h"

#include <optional>

namespace slidercrank
{

struct ReferenceData;

/// Returns which difference quotient of the column of one order less a column of velocities or accelerations contains,
/// judging by the first rows. The difference quotient has to match within the rounding of both columns, and clearly
/// better than the other difference quotients and the derivative do. Otherwise, and for a table over the crank angle,
/// returns nullopt.
std::optional<Difference> differenceIn(const ReferenceData &data, Channel channel);

} // namespace slidercrank
