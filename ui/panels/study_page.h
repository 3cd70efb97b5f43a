// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/study.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// A page for one case of the study: the error of each method against its time, as a chart and as tables. Methods that
/// compute all 36 channels and methods that compute only 6 have separate tables, because their times are not comparable.
Page studyPage(const CaseResult &result);

/// A page that says what the study does, shown before it has run.
Page emptyStudyPage();

} // namespace slidercrank
