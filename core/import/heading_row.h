// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The names of a table's columns as a row: what one of them tells of another.
//
//     X:Pos_TX-Slider   Y:Pos_TX-Slider     RecurDyn writes every curve as a pair: its instants, its values
//     Velocity (cm/s)   X-comp   Y-comp     PMKS+ writes the magnitude of a vector before its components
//     slider.s   slider.a   crank.phi       Modelica's variables are in m, rad and s, and their tables do not say so

#include "core/import/heading.h"

#include <string_view>
#include <vector>

namespace slidercrank
{

void readTogether(std::vector<Heading> &row);

/// Gives lengths and angles, and their derivatives, the unit that the file says for all of them, where they have none of
/// their own; empty: it says none. Whether any column was given one.
bool takeUnits(std::vector<Heading> &row, std::string_view ofLengths, std::string_view ofAngles);

} // namespace slidercrank
