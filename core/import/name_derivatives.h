// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the derivatives in the words of a name.

#include <string>
#include <vector>

namespace slidercrank
{

/// Removes the words that stand for a derivative, wherever they are: the dot of "theta3_dot", the d and dt of
/// "d^2x/dt^2". Returns the number of derivatives.
int takeDerivatives(std::vector<std::string> &words);

} // namespace slidercrank
