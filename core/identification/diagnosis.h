// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The diagnosis of a reference file: the conventions with which it has to be interpreted, the mechanism to which the
// data then belong, and the single parameter that explains the difference to the given mechanism.

#include "core/comparison/comparison.h"
#include "core/identification/convention.h"
#include "core/identification/identification.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// One parameter of the given mechanism, changed to the value found. A typing error is a typical cause.
struct ParameterChange {
    Parameter parameter = Parameter::A;
    double value = 0.0;
    double explained = 0.0; ///< the part of the squared error that the change removes, 0 to 1
};

/// The crank's speed at the first and the last rows, rad/s.
struct CrankSpeedChange {
    double atStart = 0.0;
    double atEnd = 0.0;
};

struct Diagnosis {
    /// In the order of application. Empty if no mechanism explains the file.
    std::vector<ConventionFinding> conventions;

    /// After the conventions are applied, no channel differs from the given mechanism.
    bool agreesWithGiven = false;

    // The following describe the data after the conventions are applied.
    Identification identification;
    std::vector<ChannelComparison> identified; ///< against identification.parameters; empty for Insufficient and None
    Parameters rounded; ///< Identified: in round numbers, as inRoundNumbers(); else identification.parameters

    /// The parameter that explains at least 99 % of the difference to the given mechanism. Set only if the file differs
    /// from it and a mechanism explains the file.
    std::optional<ParameterChange> change;

    std::optional<CrankSpeedChange> unevenCrank; ///< set if the file contains θ2 and the speed is not constant
};

/// Diagnoses a file. `mechanism` is the given one. If stopped, Identification::stopped is set.
Diagnosis diagnose(const ReferenceData &data, const Mechanism &mechanism, std::stop_token stop = {});

} // namespace slidercrank
