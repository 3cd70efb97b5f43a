// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A study of Table 1 whose times are no machine's: 5 ns for the first method, and for each of the others a third more
// than for the one before.

#include "core/study/study.h"

#include <memory>

namespace slidercrank
{

inline std::shared_ptr<const StudyResult> studyOfATurn()
{
    StudyRequest request;
    request.cases = {studyCase({})};
    request.rounds = 1;
    request.secondsPerRound = 0.0;
    auto result = std::make_shared<StudyResult>(runStudy(request));
    result->seconds = 0.8;
    double time = 5.0; // ns
    for (MethodResult &method : result->cases.front().methods) {
        method.nsPerState = time;
        method.spread = 0.1 * time;
        time *= 4.0 / 3.0;
    }
    return result;
}

} // namespace slidercrank
