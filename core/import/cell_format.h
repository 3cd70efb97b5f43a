// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds how the cells of a table are written: as numbers with a point or a comma, or as times of a clock.

#include "core/import/heading.h"
#include "core/import/lines.h"

#include <vector>

namespace slidercrank
{

/// Finds the columns of times of a clock by the first row. Times of day that no clock shows have no meaning.
void findClocks(const Line &row, char delimiter, std::vector<Heading> &headings);

/// Returns the decimal sign with which most numbers in the lines can be read: 0,005 and 1.234,5 only with a comma.
/// Between commas, "1,234" could have a thousands separator and does not count, but "0,234" does.
DecimalSign findDecimalSign(Lines lines, char delimiter);

/// Returns whether every decimal sign in the lines could also separate thousands, as in "80,826": it has three digits
/// behind it and a number from 1 to 999 before.
bool mayHaveThousands(Lines lines, char delimiter);

} // namespace slidercrank
