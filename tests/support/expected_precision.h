// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How well a file of known origin determines its mechanism: the least-squares fit, linearized at the truth.

#include "tests/support/claim_file.h"

#include <array>
#include <utility>
#include <vector>

namespace slidercrank
{

struct ExpectedPrecision {
    std::array<double, kParameterCount>
        relativeError{}; ///< standard error / parameterSizes(); infinite if undetermined
    std::vector<std::pair<Channel, double>>
        originErrors{};    ///< standard errors of the free origins, in the column's unit
    double evidence = 0.0; ///< in nats: how unlikely a fit by chance is
    double values = 0.0;
    double unknowns = 0.0;
    double unexplained = 0.0; ///< rms, in errors, of what the best fit leaves of the columns' systematic deviations
    Parameters fitted{};      ///< the truth after one step of the fit to the columns as they are
    std::vector<double> originSteps{}; ///< that step of the free origins
    bool isBent = false;               ///< three standard errors away the fit is not what its linearization says
};

/// a, b, ω2 and a radian of θ20; for c the larger of itself and the crank.
std::array<double, kParameterCount> parameterSizes(const Parameters &parameters);

/// Uses the columns that a fit can take; origins are free where the file has shifted them, a is held where the file has
/// only angles, ω2 and θ20 where it counts by the crank's angle. Requires a truth and computed values.
ExpectedPrecision expectedPrecision(const ClaimFile &file, bool areAllOriginsFree = false);

/// The systematic deviations of the columns leave more than rounding and noise, whatever mechanism and origins are
/// fitted to them. True where there are none.
bool areDeviationsVisible(const ClaimFile &file);

/// Every standard error is below 1 %, the fit is straight, and there is more than enough evidence and rows a turn.
bool determinesItsMechanism(const ClaimFile &file);

} // namespace slidercrank
