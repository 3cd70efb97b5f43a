// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a person would describe the mechanism of the last fit.

#include "core/identification/findings.h"

namespace slidercrank
{

/// Several units, numbers, mirror images and origins explain the file equally well. Changes findings.lastFit to those
/// that a person expects: the unit of most columns, round numbers, the mirror image with the simplest reading and the
/// lengths of the given mechanism. Also sets findings.otherMirrorImages and findings.change. Requires that the last fit
/// is finite. `searched`: the selected rows in which the steps before the last fit have searched.
void chooseExpectedDescription(Findings &findings, const Observations &searched, const Parameters &given);

} // namespace slidercrank
