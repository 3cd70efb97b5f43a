// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether a single wrong length of the given mechanism explains why it differs from the mechanism that produced the
// file.

#include "core/identification/fit.h"
#include "core/identification/identification.h"

#include <optional>

namespace slidercrank
{

/// Fits the given lengths to the file in the reading of `best`: only the drive and the origins are free.
Fit fitWithGivenLengths(const Observations &observations, const Fit &best, const Parameters &given);

/// Returns the only length that has to be changed so that the given mechanism explains the file as well as `best` does,
/// in the reading of `best`, with the drive and the origins fitted again. It is a round number in the unit of the file
/// if that explains the file as well. Returns nullopt if no single change suffices, or if any of several lengths could
/// be the wrong one, as all three could if the given mechanism itself explains the file.
std::optional<LengthChange> findLengthChange(const Observations &observations, const Fit &best,
                                             const Parameters &given);

} // namespace slidercrank
