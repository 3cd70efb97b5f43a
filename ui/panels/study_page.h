// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/study.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// Returns a page for one case of the study: the error of each method against its time, as a chart and as a table. The
/// time of a method that computes 36 channels is not comparable with that of a method that computes 6.
Page studyPage(const CaseResult &result);

} // namespace slidercrank
