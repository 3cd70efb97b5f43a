// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes how well a file of known origin determines its mechanism, from a least-squares fit linearized at the truth.

#include "tests/support/claim_file.h"

namespace slidercrank
{

/// Returns the size of each parameter: a, b, ω2, one radian for θ20, and max(|c|, a) for c.
std::array<double, kParameterCount> parameterSizes(const Parameters &parameters);

/// Returns whether a fit can use a column.
bool canBeFitted(Channel channel);

/// Returns the standard error of the origin of a column, in its unit. 0 if the file does not determine it.
double originError(const ClaimFile &file, Channel channel);

/// Returns whether the residual of every fit exceeds rounding and noise because of the systematic deviations of the
/// columns. Also true if no column has a systematic deviation.
bool areDeviationsVisible(const ClaimFile &file);

/// Returns whether every standard error is below 1 %, the linearization is valid, and evidence and rows per turn are
/// sufficient.
bool determinesItsMechanism(const ClaimFile &file);

} // namespace slidercrank
