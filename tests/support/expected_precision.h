// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes how well a file of known origin determines its mechanism, from a least-squares fit linearized at the truth.

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
    double evidence = 0.0; ///< against a fit by chance, in nats
    double values = 0.0;
    double unknowns = 0.0;
    double unexplained = 0.0;          ///< rms of the systematic deviations after the best fit, in errors
    Parameters fitted{};               ///< the truth after one step of the fit to the actual columns
    std::vector<double> originSteps{}; ///< the same step, for the free origins
    bool isBent = false;               ///< the linearization fails three standard errors away
};

/// Returns the size of each parameter: a, b, ω2, one radian for θ20, and max(|c|, a) for c.
std::array<double, kParameterCount> parameterSizes(const Parameters &parameters);

/// Computes the precision from the columns that a fit can use. Origins are free where the file has shifted them. a is
/// fixed if the file has only angles; ω2 and θ20 are fixed if its first column is the crank angle. Requires a truth and
/// computed values.
ExpectedPrecision expectedPrecision(const ClaimFile &file, bool areAllOriginsFree = false);

/// Returns whether the residual of every fit exceeds rounding and noise because of the systematic deviations of the
/// columns. Also true if no column has a systematic deviation.
bool areDeviationsVisible(const ClaimFile &file);

/// Returns whether every standard error is below 1 %, the linearization is valid, and evidence and rows per turn are
/// sufficient.
bool determinesItsMechanism(const ClaimFile &file);

} // namespace slidercrank
