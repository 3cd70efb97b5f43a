// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lists the conventions of a file, applies them, and compares the corrected file with the mechanism found.

#include "core/identification/findings.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace slidercrank
{

/// Adds the conventions of an identified or approximate mechanism to `result`, and the comparisons of the used columns
/// with it and with the given mechanism. Also sets the unit of the lengths, and the residuals in the units of the
/// corrected file, which is the file after all conventions are applied. If conventions of the whole file lead to the
/// given mechanism, result.parameters become those of the corrected file, and the alternatives are removed. These
/// parameters are the given ones within their errors. Only the assembly remains the one found, because
/// Kind::OtherAssembly does not change the file. `data`: the table as it is in the file. `tableConvention`: the
/// convention that was applied to the table before it was observed; it becomes the first of the conventions.
void addConventionsAndComparisons(Identification &result, const ReferenceData &data,
                                  const std::optional<Convention> &tableConvention, const Findings &findings,
                                  const Parameters &given);

/// Whether a value in a row of the file is farther from the mechanism found than four bounds of rounding. `data`: as
/// for addConventionsAndComparisons(), which has added the conventions to `result`.
bool isRowContradicted(const Identification &result, const ReferenceData &data, std::size_t row,
                       const Findings &findings);

/// Whether all columns agree with a mechanism.
bool allAgree(const std::vector<ChannelComparison> &channels);

} // namespace slidercrank
