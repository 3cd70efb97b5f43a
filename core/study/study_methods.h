// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lists the methods that the study compares.

#include "core/mechanism/channel.h"
#include "core/newton/newton_options.h"
#include "core/study/study.h"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

/// What a method computes at its time stamps. Values in the order of kPlottedChannels (mm, rad, s).
struct StudyOutput {
    std::array<std::vector<double>, kPlottedChannels.size()> values;
    std::vector<Status> statuses;
    long long iterations = 0;
};

/// Fills the output, whose vectors have one element for each time stamp. Can be called repeatedly.
using StudyRun = std::function<void(StudyOutput &)>;

struct StudyMethod {
    MethodName name{};
    std::optional<double> tolerance{}; ///< of Newton-Raphson
    int channels = 6;
    bool dependsOnStep = true;    ///< whether its error, or its cost for the same outputs, depends on the step size
    bool needsEqualSteps = false; ///< whether it can be run only at equal time steps

    /// Does the work that is needed once per mechanism, and returns the function that is timed, which refers to the
    /// ascending time stamps. Returns null if the method does not apply.
    std::function<StudyRun(const Mechanism &, std::span<const double> timeStamps)> prepare{};
};

/// Returns all methods, the slowest first.
const std::vector<StudyMethod> &studyMethods();

} // namespace slidercrank
