// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What can be said about the mechanism of a file.

#include "core/identification/findings.h"

namespace slidercrank
{

/// Whether a file has too few rows or columns for any fit; Nothing if it has enough.
Identification::Lack findLack(const Observations &observations);

/// The outcome without conventions and comparisons. Insufficient: the file has too few values, or leaves parameters of
/// a mechanism open that explains it. None: no mechanism explains it.
Identification judge(const ReferenceData &data, const Findings &findings, const Parameters &given);

} // namespace slidercrank
