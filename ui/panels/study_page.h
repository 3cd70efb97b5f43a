// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/study.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// Returns a page for one case (mechanism) of the study: the error of each method against its time, as a chart and as a
/// table. The times of methods that compute 36 channels are not comparable with those of methods that compute 6.
Page studyPage(const CaseResult &result);

} // namespace slidercrank
