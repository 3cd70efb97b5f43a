// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Decides what can be said about the mechanism: whether the file determines it, with which standard errors, and whether
// another mechanism explains the file equally well.

#include "core/identification/acceptance.h"
#include "core/identification/identification.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

/// The reason why the file cannot determine a mechanism, apart from its values; nullopt if there is none.
std::optional<Identification::Lack> findLack(const Observations &data);

/// The precision of a fit.
struct Uncertainty {
    Eigen::VectorXd errors;                                ///< standard errors of the unknowns; NaN if held
    std::array<double, kParameterCount> parameterErrors{}; ///< the first of them; θ20: in the middle of the file
    double angleAtZero = 0.0;                              ///< standard error of θ20 at t = 0
    double conditionNumber = 0.0;
    double evidence = 0.0;   ///< the information that the mechanism gives about the values, in nats
    bool isParabolic = true; ///< chi-square is a parabola within three standard errors, up to a factor of 2

    /// The standard error of the origin of a column or of the crank angle, in the unit of files.
    double originError(const Hypothesis &hypothesis, Channel channel) const;
};

/// The answer, and the candidate to which it belongs: that of the images that is most like the given mechanism.
struct Decision {
    Identification identification;
    Candidate candidate;
    Uncertainty uncertainty;
};

/// Chooses the nearest of the candidates that interpret the file as its headings say. The outcome is Nearest or None.
Identification decideNearest(const Observations &data, std::span<const Candidate> candidates, const Parameters &given);

/// Decides between candidates that are sorted from best to worst. The outcome is None if no candidate is accepted.
Decision decide(const Observations &data, std::span<const Candidate> candidates, const Parameters &given);

} // namespace slidercrank
