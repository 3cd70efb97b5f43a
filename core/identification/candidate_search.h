// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds, fits and judges the competing hypotheses about a file: first as its headings say, then with free origin
// offsets, then with every other interpretation, including exchanged columns.

#include "core/identification/acceptance.h"

#include <stop_token>
#include <vector>

namespace slidercrank
{

/// Whether a hypothesis uses every column as its heading says.
bool isAsWritten(const Observations &data, const Hypothesis &hypothesis);

/// Whether the first of the candidates is identified.
bool isIdentified(const std::vector<Candidate> &candidates);

/// Fits and judges a hypothesis.
Candidate fitCandidate(const Observations &data, Hypothesis hypothesis);

/// Returns the candidates, the best one first. `given` supplies parameters that the file does not determine: a length,
/// or ω2 of a file by crank angle.
std::vector<Candidate> searchCandidates(const Observations &data, const Parameters &given, const std::stop_token &stop);

} // namespace slidercrank
