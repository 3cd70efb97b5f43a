// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the numbers of a column say of how its quantity moves, where its name and unit leave that open. The time is in
// s, the values in any unit; NaN where a cell has none.

#include "core/mechanism/channel.h"
#include "core/import/unit_text.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// No gap, and each value above the one before.
bool onlyRises(const std::vector<double> &values);

/// Whether the quantity changes at one rate throughout: a position on a line through its ends, a velocity that is
/// constant and not zero, an acceleration that is zero.
bool isEven(const std::vector<double> &time, const std::vector<double> &values, Order order);

/// Whether `rate` is the time derivative of `values`. Also where there is too little to judge by.
bool isDerivative(const std::vector<double> &time, const std::vector<double> &values, const std::vector<double> &rate);

/// Whether a position that goes to and fro is the coupler's angle, in degrees or radians, or a length; nothing where
/// the numbers do not tell.
std::optional<Dimension> dimensionOf(const std::vector<double> &position, const std::vector<double> &velocity,
                                     const std::vector<double> &acceleration);

} // namespace slidercrank
