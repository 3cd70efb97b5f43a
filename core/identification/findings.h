// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a hypothesis says of the file in terms that a person can apply: its conventions, and what the whole file means
// when it is compared with the given mechanism.

#include "core/identification/convention.h"
#include "core/identification/decision.h"
#include "core/identification/diagnosis.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// The conventions of an accepted candidate, in the order of application. Origin offsets are named from 5 standard
/// errors and a thousandth of the column's spread.
std::vector<ConventionFinding> findConventions(const Observations &data, const Candidate &candidate,
                                               const Uncertainty &uncertainty);

/// What makes the file as a whole the motion of the given mechanism: its units of length and time, the sense of
/// rotation, the other assembly, a late start; the fewest that do, two at most. `found` becomes the mechanism of the
/// data so interpreted. Empty where the mechanism found is no image of the given one.
std::vector<ConventionFinding> findFaultsOfWholeFile(const ReferenceData &data, const Parameters &given,
                                                     Identification &found);

/// Sets the largest error of each finding without and with it, and removes those that do not reduce it; returns whether
/// all do that change numbers. `data`: a file
/// by crank angle is timed by the mechanism already.
bool measureFindings(const ReferenceData &data, const Parameters &found, std::vector<ConventionFinding> &findings);

/// All conventions applied, one after the other.
ReferenceData allApplied(const std::vector<ConventionFinding> &findings, ReferenceData data);

/// The one parameter of the given mechanism that, substituted by the one found, explains 99 % of the squared error.
std::optional<ParameterChange> findParameterChange(const ReferenceData &data, const Parameters &given,
                                                   const Parameters &found);

/// At most so many rows, evenly spread.
ReferenceData thinnedData(const ReferenceData &data, std::size_t count);

} // namespace slidercrank
