// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the words of a name that mark it as a derivative.

#include <string>
#include <vector>

namespace slidercrank
{

/// Removes the words that mark a derivative, wherever they are: the dot of "theta3_dot", the d and dt of "d^2x/dt^2".
/// Returns how often they differentiate the quantity.
int takeDerivatives(std::vector<std::string> &words);

} // namespace slidercrank
