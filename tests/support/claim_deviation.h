// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks that the deviations, noise, omitted columns and excluded rows of a claim agree with the mechanism it claims.

#include "tests/support/claim_file.h"
#include "tests/support/program_claim.h"

#include <string>
#include <string_view>

namespace slidercrank
{

/// Returns whether the claim states the finding `name` for the channel.
bool hasFinding(const ProgramClaim &claim, std::string_view name, Channel channel);

/// Returns whether the claim lists the channel as left out of the fit.
bool isLeftOut(const ProgramClaim &claim, Channel channel);

/// Returns one - other; for angles, without whole turns.
long double differenceIn(Channel channel, long double one, long double other);

/// Describes the first of these statements that is false. Returns an empty string if all are true.
std::string falseDeviation(const ClaimFile &file, const ReferenceData &data, const ProgramClaim &claim);

} // namespace slidercrank
