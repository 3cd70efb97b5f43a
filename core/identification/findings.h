// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Expresses a hypothesis as conventions that can be applied to the file, and compares the file with the given
// mechanism.

#include "core/identification/convention.h"
#include "core/identification/decision.h"
#include "core/identification/diagnosis.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// The conventions of an accepted candidate, in the order of application.
std::vector<ConventionFinding> findConventions(const Observations &data, const Candidate &candidate,
                                               const Uncertainty &uncertainty);

/// The conventions that turn the whole file into the motion of the given mechanism: units of length and time, sense of
/// rotation, assembly, a late start; at most two of them, and as few as possible. Changes `found` to the mechanism of
/// the data after they are applied. Empty if there are none.
std::vector<ConventionFinding> findFaultsOfWholeFile(const ReferenceData &data, const Parameters &given,
                                                     Identification &found);

/// Sets the largest error without and with each finding, and removes findings that do not reduce it. Returns false if
/// one of these would change values.
bool measureFindings(const ReferenceData &data, const Parameters &found, std::vector<ConventionFinding> &findings);

/// Compares the data with a mechanism. A file by crank angle gets the time stamps of that mechanism.
std::vector<ChannelComparison> compareTimed(const Parameters &parameters, const ReferenceData &data,
                                            const std::stop_token &stop = {});

/// Applies all conventions, one after the other.
ReferenceData allApplied(const std::vector<ConventionFinding> &findings, ReferenceData data);

/// The parameter of the given mechanism whose replacement by the value found explains at least 99 % of the squared
/// error; nullopt if there is none.
std::optional<ParameterChange> findParameterChange(const ReferenceData &data, const Parameters &given,
                                                   const Parameters &found);

/// At most a thousand rows, evenly spread.
ReferenceData thinned(ReferenceData data);

/// The largest error of some channels (all if `channels` is empty) in percent of their peaks; 0 if there are no values,
/// infinite if the mechanism cannot be assembled in some row.
double largestPercent(const Parameters &parameters, const ReferenceData &data,
                      const std::vector<Channel> &channels = {});

} // namespace slidercrank
