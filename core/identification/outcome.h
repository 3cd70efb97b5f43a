// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What can be said about the mechanism of a file.

#include "core/identification/findings.h"

namespace slidercrank
{

/// What a file lacks for any fit: rows (FewValues), columns that change (NothingMoves) or Nothing.
Identification::Lack findLack(const Observations &observations);

/// The outcome without conventions and comparisons. Insufficient: the file has too few values, or leaves parameters
/// of the mechanism that explains it open. None: no mechanism explains it. `data`: the file from which `findings` were
/// made. `given`: supplies the parameters that the file does not determine.
Identification judge(const ReferenceData &data, const Findings &findings, const Parameters &given);

} // namespace slidercrank
