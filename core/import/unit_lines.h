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

/// Returns the unit in a cell below the headings, if the cell contains nothing else ("mm", "(mm)") or Simulink wrote it
/// ("Type: double Unit: rad"). Otherwise empty.
std::string_view unitIn(std::string_view cell);

/// Sets the unit of a column that is found in cell `i` of a line, unless it is empty. Throws if the heading states a
/// different one. What its brackets contain is a remark if it is no unit: "x (FD2)" above "mm".
void setUnit(std::vector<Heading> &headings, std::size_t i, std::string_view unit, std::size_t line);

/// Sets the units that stand directly above the headings, if all cells of the line are units: "s,cm", "# units: s, cm".
/// Otherwise the line has the names of headings that are only units: "Crank angle,Slider" above "[deg],Position [mm]".
void readLineAbove(const Line &line, char delimiter, std::vector<Heading> &headings);

/// Interprets the lines between the headings and the first number, which may contain units or continue the headings.
/// Returns how many there are. `row` states the delimiter.
std::size_t readAnnotations(Lines lines, const NumberRow &row, std::vector<Heading> &headings);

} // namespace slidercrank
