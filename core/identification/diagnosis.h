// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All that can be found out about a file held against a mechanism: the conventions by which it reads otherwise than it
// says, and, with those applied, the mechanism that it belongs to and the one parameter that explains the difference.

#include "core/comparison/comparison.h"
#include "core/identification/convention.h"
#include "core/identification/identification.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// One parameter of the given mechanism, changed to what was found: a number mistyped, a length changed in one program
/// and not in the other.
struct ParameterChange {
    Parameter parameter = Parameter::A;
    double value = 0.0;
    double explained = 0.0; ///< the part of the squared error that is gone, 0 to 1
};

/// The crank's speed at the first and the last rows, rad/s.
struct CrankSpeedChange {
    double atStart = 0.0;
    double atEnd = 0.0;
};

struct Diagnosis {
    /// In the order in which they are to be applied. Empty unless Identified or Ambiguous, or the file, so read, is the
    /// motion of the mechanism at hand.
    std::vector<ConventionFinding> conventions;

    /// With them (without, where there are none) no channel differs from the mechanism at hand.
    bool agreesWithGiven = false;

    // All these of the data as they read with the conventions.
    Identification identification;
    std::vector<ChannelComparison> identified; ///< against identification.parameters; empty for Insufficient and None
    Parameters rounded; ///< Identified: in round numbers, as inRoundNumbers(); else identification.parameters

    /// The one parameter that explains 99 % of the difference or more. Only where the file differs from the mechanism
    /// at hand, the outcome is Identified or Ambiguous, and the change leaves a sensible mechanism: a length not beyond
    /// a hundredth and a hundred times the others.
    std::optional<ParameterChange> change;

    /// The file does not say what its lengths are in, and read as mm the crank is shorter than one.
    bool mayBeInMetres = false;

    /// The file counts by the crank's angle, and ω2 is what its derivatives by the time say.
    bool isSpeedOfDerivatives = false;

    std::optional<CrankSpeedChange> unevenCrank; ///< θ2 is in the file and does not advance evenly
};

Diagnosis diagnose(const ReferenceData &data, const Mechanism &mechanism, std::stop_token stop = {});

} // namespace slidercrank
