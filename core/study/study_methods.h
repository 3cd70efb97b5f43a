// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The ladder of methods that the study compares, one entry each.

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

/// What a method says of its instants. Values by kPlottedChannels, in mm, s and the method's unit of angles.
struct StudyAnswers {
    std::array<std::vector<double>, kPlottedChannels.size()> values;
    std::vector<Status> status;
    long long iterations = 0;
};

/// Fills the answers, which have the size of its instants. May be called again and again.
using StudyRun = std::function<void(StudyAnswers &)>;

struct StudyMethod {
    enum class Instants {
        All,     ///< instantsOf() the case
        Sampling ///< the equal steps of its sampling alone
    };

    MethodName name{};
    std::optional<double> tolerance{}; ///< of Newton-Raphson
    int channels = 6;
    bool dependsOnStep = true; ///< its error or its cost for the same outputs
    Instants instants = Instants::All;

    /// What is to be worked out once per mechanism is done here; the run is timed. Null where the method does not
    /// apply.
    std::function<StudyRun(const Case &, std::span<const double> instants)> prepare{};
};

/// In the order of the ladder, slowest way first.
const std::vector<StudyMethod> &studyMethods();

} // namespace slidercrank
