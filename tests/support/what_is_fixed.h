// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a file of known origin fixes of its mechanism: the least-squares fit, linearized at the truth.

#include "tests/support/claim_files.h"

#include <array>
#include <utility>
#include <vector>

namespace slidercrank
{

struct WhatIsFixed {
    std::array<double, kParameterCount> part{}; ///< standard error by partSizes(); infinite where nothing fixes it
    std::vector<std::pair<Channel, double>> zeroErrors; ///< standard errors of the free zeros, in the column's unit
    double evidence = 0.0;                              ///< in nats: how unlikely a fit by chance is
    double values = 0.0;
    double unknowns = 0.0;
    bool isBent = false; ///< three standard errors away the fit is not what its linearization says: ± is no ±
};

/// Of a, b, ω and a radian of θ20; of c the larger of itself and the crank.
std::array<double, kParameterCount> partSizes(const Parameters &parameters);

/// Of the columns that a fit can take; zeros are free where the file has shifted them, a is held where only angles are
/// there. Precondition: the file has a truth.
WhatIsFixed whatIsFixed(const ClaimFile &file);

/// Whether the file fixes its mechanism: every standard error below 1 %, the fit straight, more than enough evidence,
/// and rows enough to tell the speed.
bool fixesTheMechanism(const ClaimFile &file);

} // namespace slidercrank
