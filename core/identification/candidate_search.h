// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All hypotheses about a file that compete, fitted and judged: as its headings say first, then with free origin
// offsets, then with every other interpretation, and with columns under each other's names.

#include "core/identification/acceptance.h"

#include <stop_token>
#include <vector>

namespace slidercrank
{

/// Whether every column is used as its heading says.
bool isAsWritten(const Observations &data, const Candidate &candidate);

/// A hypothesis fitted and judged, once with rounded and once with exact abscissae where it is uneven: the better one.
Candidate fitCandidate(const Observations &data, Hypothesis hypothesis);

/// The best first. `given` supplies what the file does not hold: a length, or ω2 of a file by crank angle.
std::vector<Candidate> searchCandidates(const Observations &data, const Parameters &given, const std::stop_token &stop);

} // namespace slidercrank
