// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whether the deviations, noise, columns left out and rows excluded that a claim states are those of its own mechanism.

#include "tests/support/claim_file.h"
#include "tests/support/program_claim.h"

#include <string>
#include <string_view>

namespace slidercrank
{

bool hasFinding(const ProgramClaim &claim, std::string_view name, Channel channel);

bool isLeftOut(const ProgramClaim &claim, Channel channel);

/// Less whole turns, for angles.
long double differenceIn(Channel channel, long double one, long double other);

/// Why one of them is false; empty if none is.
std::string falseDeviation(const ClaimFile &file, const ReferenceData &data, const ProgramClaim &claim);

} // namespace slidercrank
