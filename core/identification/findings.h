// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a file has to be read, as conventions that a person can apply, and the comparison of the file, read in this way,
// with a mechanism.

#include "core/identification/identification.h"
#include "core/identification/last_fit.h"

#include <stop_token>
#include <vector>

namespace slidercrank
{

/// The conventions that turn the columns of the file into those of the mechanism of the last fit, in the order of their
/// application.
std::vector<ConventionFinding> listConventions(const LastFit &lastFit);

/// Applies conventions in their order.
ReferenceData applyAll(const std::vector<ConventionFinding> &conventions, ReferenceData data);

/// Compares a mechanism with a file to which all conventions have been applied. If the speed of the crank is not
/// constant, positions are compared as in a table over the crank angle, and derivatives are not compared. `fitted`: how
/// the mechanism was fitted to the file; {} if it was not.
std::vector<ChannelComparison> compareReadFile(const Parameters &mechanism, const ReferenceData &data,
                                               Drive::Kind drive, const FittedMechanism &fitted,
                                               const std::stop_token &stop);

/// Sets `before` and `after` of the conventions of a mechanism.
void measureConventions(std::vector<ConventionFinding> &conventions, const Parameters &mechanism,
                        const ReferenceData &data, Drive::Kind drive);

} // namespace slidercrank
