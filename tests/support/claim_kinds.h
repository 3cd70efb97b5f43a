// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The kinds of claim tables in groups, which claimKinds() joins.

#include "tests/support/claim_table.h"

namespace slidercrank
{

// claim_kinds.cpp
std::vector<ClaimKind> plainTables();
std::vector<ClaimKind> limitTables();
std::vector<ClaimKind> otherMotions();

// claim_kinds_of_conventions.cpp
std::vector<ClaimKind> tablesByAngle();
std::vector<ClaimKind> tablesWithConventions();
std::vector<ClaimKind> tablesBesideAGivenMechanism();

// claim_kinds_of_sensors.cpp
std::vector<ClaimKind> filteredTables();
std::vector<ClaimKind> contradictoryTables();
std::vector<ClaimKind> sensorTables();
std::vector<ClaimKind> clockTables();

/// Returns one of the first or second derivatives of R4_x and θ3.
Channels randomDerivative(ClaimRandom &random);

} // namespace slidercrank
