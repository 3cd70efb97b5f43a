// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From candidates to an outcome: what may be claimed.

#include "core/identification/candidate.h"
#include "core/identification/identification.h"

#include <optional>
#include <span>

namespace slidercrank
{

/// Before anything is fitted: too little, or nothing moves.
std::optional<Identification::Lack> lackOf(const Observations &observations);

/// `candidates`: on the same rows, the best first; those that stand before all others. `given`: the mechanism at hand.
Identification decisionOn(const SearchRows &rows, std::span<const Candidate> candidates, const Parameters &given,
                          const std::stop_token &stop);

} // namespace slidercrank
