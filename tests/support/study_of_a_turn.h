// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A study of Table 1 in few steps, with artificial times that do not depend on the machine: 5 ns for the first method,
// and a third more for each following method.

#include "core/study/study.h"

#include <memory>

namespace slidercrank
{

inline std::shared_ptr<const StudyResult> studyOfATurn()
{
    StudyRequest request;
    request.cases = {studyCase({})};
    request.cases.front().sampling.steps = 20;
    request.rounds = 1;
    request.secondsPerRound = 0.0;
    auto result = std::make_shared<StudyResult>(runStudy(request));
    result->seconds = 0.8;
    double time = 5.0; // ns
    for (MethodResult &method : result->cases.front().methods) {
        method.nanosecondsPerState = time;
        method.spread = 0.1 * time;
        time *= 4.0 / 3.0;
    }
    return result;
}

} // namespace slidercrank
