// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the Newton-Raphson tab writes into its tables: equations, Jacobian, iterations and coordinates at one instant.
// Numbers in the core's units (mm, rad, s), coordinates in those of the author's files (mm, °, s).

#include "core/newton/newton.h"
#include "core/sampling/instant_equations.h"
#include "ui/widgets/number_table.h"

#include <QString>

namespace slidercrank
{

/// "A, x", "drive": where a constraint belongs.
QString nameOf(Constraint row);

/// The longest of those, and of the bodies' names: as wide as their columns have to be.
QString longestConstraintName();
QString longestBodyName();

std::vector<TableColumn> equationColumns();
std::vector<TableRow> equationRows(const InstantEquations &equations);

/// The first column names the constraint, the others are the coordinates.
std::vector<TableColumn> jacobianColumns();
std::vector<TableRow> jacobianRows(const Mechanism &mechanism, const InstantEquations &equations);

std::vector<TableColumn> coordinateColumns();
std::vector<TableRow> coordinateRows(const Mechanism &mechanism, const State &state);

/// Side by side, a row an iteration.
std::vector<TableColumn> iterationColumns();
std::vector<TableRow> iterationRows(const IterationHistory &fromAfar, const IterationHistory &fromBefore);

} // namespace slidercrank
