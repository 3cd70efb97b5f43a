// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Interprets the headings of a table by regarding all of them together, and the values below them.

#include "core/import/raw_table.h"

#include <span>

namespace slidercrank
{

/// Decides what the headings of a file leave open, completes their units, and sets the reasons why columns are ignored:
///
///     Velocity (cm/s)   X-comp   Y-comp     a vector of PMKS+: the magnitude is ignored, the components have its unit
///     slider.s   slider.a   crank.phi       Modelica: m, rad and s are implied, unless the values contradict them
///     x   xp   xpp                          xp is a derivative, because xpp can be nothing else
///     ω   α                                 α behind ω is the angular acceleration; otherwise it is an angle if it
///                                           turns by more than half a turn
///     x   y   x   y                         Tracker: two points, of which one may be the slider
void interpretHeadings(std::span<RawColumn> columns);

} // namespace slidercrank
