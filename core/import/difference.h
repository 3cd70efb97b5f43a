// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Velocities and accelerations that are differences: a program that knows positions only writes how they change from
// row to row. These are the derivative half a step away, and of positions with few digits mostly rounding.

#include "core/import/file_layout.h"

#include <optional>

namespace slidercrank
{

struct ReferenceData;

/// What the first rows of the column are of the column of one order less: only where they are that as far as both
/// columns' digits go, and are nothing else as nearly, a derivative neither.
std::optional<Difference> differenceIn(const ReferenceData &data, Channel channel);

} // namespace slidercrank
