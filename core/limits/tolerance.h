// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes how much the limits of a motion change while the lengths vary within their tolerances. Lengths in mm.
//
// To first order the change of a limit f is ±(|∂f/∂a| δa + |∂f/∂b| δb + |∂f/∂c| δc). This estimate fails where f is
// stationary: the time ratio, for example, can only grow from c = 0. Therefore the exact range is computed. Almost
// always, f is largest and smallest at corners of the box of lengths, otherwise at c = 0 or at an extremum along one of
// the lengths, which is searched.

#include "core/limits/limit.h"

#include <array>
#include <optional>

namespace slidercrank
{

/// Each length may be this much shorter or longer; 0 if it is exact.
struct LengthTolerances {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
};

/// The smallest and the largest value of a limit; of a peak, those of its magnitude.
struct LimitRange {
    double least = 0.0;
    double greatest = 0.0;
};

/// The ranges of all limits, indexed by LimitKind. An entry is empty if its limit does not exist, or is unbounded, for
/// some of the lengths, and for CrankLimit.
using LimitRanges = std::array<std::optional<LimitRange>, kLimitKindCount>;

LimitRanges limitRanges(const Mechanism &mechanism, const LengthTolerances &tolerances);

} // namespace slidercrank
