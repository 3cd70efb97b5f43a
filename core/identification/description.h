// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a person would describe the mechanism of the last fit.

#include "core/identification/findings.h"

namespace slidercrank
{

/// Several units, numbers, mirror images and origins explain the file equally well. Changes the last fit to those that
/// a person expects: the unit of most columns, round numbers, the simplest reading and the lengths of the given
/// mechanism. `searched`: selected rows.
void chooseExpectedDescription(Findings &findings, const Observations &searched, const Parameters &given);

} // namespace slidercrank
