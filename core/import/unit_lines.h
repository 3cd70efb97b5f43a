// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Interprets the lines directly above and below the headings, which contain units or further headings:
//
//     Time   Piston          Piston    Piston              Crank angle   Slider
//     [s]    [mm]            Position [mm]  Velocity [mm/s]   [deg]      Position [mm]

#include "core/import/heading.h"
#include "core/import/number_rows.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// Returns the unit in a cell above or below the headings, if the cell contains nothing else ("mm", "(mm)", "in mm") or
/// Simulink wrote it ("Type: double Unit: rad"). Otherwise returns an empty text.
std::string_view unitIn(std::string_view cell);

/// Sets the unit of column `i` to one that was found in the line with the number `line`; does nothing if `unit` is
/// empty or the column has no heading. Throws if the heading states a different unit. If the brackets of the heading
/// contain no known unit, they are a remark, as in "x (FD2)" above "mm".
void setUnit(std::vector<Heading> &headings, std::size_t i, std::string_view unit, std::size_t line);

/// Interprets the line directly above the headings. If all its cells are units, "s,cm" or "# units: s, cm", they are
/// those of the columns. Otherwise it contains the names for headings that are only units: "Crank angle,Slider" above
/// "[deg],Position [mm]".
void readLineAbove(const Line &line, char delimiter, std::vector<Heading> &headings);

/// Interprets the lines between the headings and the first number, which may contain units or continue the headings.
/// Returns the number of these lines. `row`: the row of numbers.
std::size_t readAnnotations(Lines lines, const NumberRow &row, std::vector<Heading> &headings);

} // namespace slidercrank
