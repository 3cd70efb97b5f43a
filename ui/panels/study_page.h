// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/study.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// A case of the study: error against time for each method, as a chart and as tables. Methods that compute all 36
/// channels and those that compute only 6 have a table each, for their times cannot be compared.
Page studyPage(const CaseResult &result);

/// What the study does, before it has run.
Page emptyStudyPage();

} // namespace slidercrank
