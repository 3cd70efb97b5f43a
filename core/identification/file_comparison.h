// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The conventions of a file, and its comparison, after they are applied, with the mechanism found.

#include "core/identification/findings.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// Adds the conventions of an identified or approximate mechanism, and the comparisons of the used columns with it and
/// with the given mechanism. If conventions of the whole file lead to the given mechanism, the parameters become
/// those that are found after these conventions: the given ones within their errors, apart from the assembly; then
/// there are no alternatives. `data`: the table as it is in the file. `tableConvention`: the one that was applied to it
/// before it was observed; it becomes the first of the conventions.
void addConventionsAndComparisons(Identification &result, const ReferenceData &data,
                                  const std::optional<Convention> &tableConvention, const Findings &findings,
                                  const Parameters &given);

/// Whether all columns agree with a mechanism.
bool allAgree(const std::vector<ChannelComparison> &channels);

} // namespace slidercrank
