// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From candidates to an answer: whether the file determines its mechanism, what the standard errors are, and whether
// another mechanism explains the file as well.

#include "core/identification/acceptance.h"
#include "core/identification/identification.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

/// What is missing in a file, whatever its values are.
std::optional<Identification::Lack> findLack(const Observations &data);

/// What a fit is worth.
struct Uncertainty {
    std::array<double, kParameterCount> standardError{}; ///< of θ20 in the middle of the file; NaN where held
    double angleAtZero = 0.0;                            ///< standard error of θ20 at t = 0
    std::vector<double> offsetErrors;                    ///< by column; NaN where there is no offset
    double conditionNumber = 0.0;
    double evidence = 0.0;  ///< how much better than chance the values are met, in nats
    bool isStraight = true; ///< three standard errors in any direction cost what a parabola would, within a factor of 2
};

Uncertainty computeUncertainty(const Observations &data, const Candidate &candidate);

/// The answer and the hypothesis that it is about.
struct Decision {
    Identification identification;
    std::optional<Candidate> candidate; ///< with an image that suits the given mechanism best; none where none is near
    Uncertainty uncertainty;            ///< only where a mechanism is accepted
};

/// What comes nearest of the candidates that interpret the file as its headings say: Nearest, or None.
Decision decideNearest(const Observations &data, std::span<const Candidate> candidates, const Parameters &given);

/// `candidates`: the best first.
Decision decide(const Observations &data, std::span<const Candidate> candidates, const Parameters &given);

} // namespace slidercrank
