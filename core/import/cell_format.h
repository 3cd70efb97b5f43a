// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds how the cells of a table are written: as numbers with a point or a comma, or as times of a clock.

#include "core/import/heading.h"
#include "core/import/lines.h"

#include <vector>

namespace slidercrank
{

/// Marks the columns whose cells contain times of a clock, judging by the first row. Behind the first quantity there
/// are none: "1:02" may be the duration of a lap there. A heading that names a time of day has no meaning if its cells
/// are no times of a clock.
void markClocks(const Line &row, char delimiter, std::vector<Heading> &headings);

/// Returns the decimal sign with which more cells of the lines are numbers; the point on a tie. If commas also separate
/// the cells, "1,234" does not speak for a decimal comma, because its comma may separate thousands, but "0,234" does.
DecimalSign findDecimalSign(Lines lines, char delimiter);

/// Returns whether every decimal sign in the lines could also separate thousands, as in "80,826": three digits are
/// behind it, and a number from 1 to 999 is before it. Returns false if there is no decimal sign, or if commas separate
/// the cells.
bool mayHaveThousands(Lines lines, char delimiter);

} // namespace slidercrank
