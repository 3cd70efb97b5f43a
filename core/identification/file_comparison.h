// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lists the conventions of a file, applies them, and compares the corrected file with the mechanism found.

#include "core/identification/findings.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace slidercrank
{

/// Adds the conventions of an identified or approximate mechanism, and the comparisons of the used columns with it and
/// with the given mechanism. If conventions of the whole file lead to the given mechanism, the parameters become
/// those of the corrected file, without alternatives. They are the given ones within their errors, but with the
/// assembly found: Kind::OtherAssembly changes the model, and not the file. Also sets the unit of the lengths, and the
/// residuals in the units of the corrected file. `data`: the table as it is in the file. `tableConvention`: the one
/// that was applied to it before it was observed; it becomes the first of the conventions.
void addConventionsAndComparisons(Identification &result, const ReferenceData &data,
                                  const std::optional<Convention> &tableConvention, const Findings &findings,
                                  const Parameters &given);

/// Whether a value in a row of a file is far from the mechanism found, in comparison with rounding. `data`: as for
/// addConventionsAndComparisons(), which has added the conventions.
bool isRowContradicted(const Identification &result, const ReferenceData &data, std::size_t row,
                       const Findings &findings);

/// Whether all columns agree with a mechanism.
bool allAgree(const std::vector<ChannelComparison> &channels);

} // namespace slidercrank
