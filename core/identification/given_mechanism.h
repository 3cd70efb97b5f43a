// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Relates the mechanism found to the given one: which single change explains the difference.

#include "core/identification/identification.h"
#include "core/identification/last_fit.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// Fits the given lengths to the file in the reading of `best`: only the drive and the origins are free.
Fit fitWithGivenLengths(const Observations &observations, const Fit &best, const Parameters &given);

/// Whether a fit with fewer unknowns explains the file as well as `best`: its residuals are rounding, or its misfit is
/// not higher by more than its residuals prove.
bool explainsAsWell(const Observations &observations, const Fit &fit, const Fit &best);

/// Returns the only length that has to be changed so that the given mechanism explains the file, in the reading of
/// `best` and with its drive, as well as `best` does. It is a round number of `lengthUnit` (mm) if that explains the
/// file as well. nullopt if nothing has to be changed, or if no length or several could be the wrong one.
std::optional<LengthChange> findLengthChange(const Observations &observations, const Fit &best, const Parameters &given,
                                             double lengthUnit);

/// Conventions of the whole file, and the mechanism that is found in the file when they are applied to it.
struct WholeFileReading {
    std::vector<ConventionFinding> conventions{};
    Parameters parameters;
    ParameterErrors standardError{};
};

/// A different length unit, times per millisecond, the other sense of rotation, a late start and the other assembly
/// cannot be distinguished from another mechanism. Returns such conventions only if the mechanism found is the given
/// one after they are applied, and only if one or two of them are sufficient (in a file with θ2: one). Otherwise
/// returns no conventions, and `found`. `data`: the file after all other conventions were applied.
WholeFileReading findWholeFileReading(const ReferenceData &data, const Parameters &found,
                                      const ParameterErrors &standardError, const Parameters &given);

} // namespace slidercrank
