// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/study.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// A page for one case of the study: the error of each method against its time, as a chart and as a table. The
/// times of methods that compute 36 channels and of those that compute 6 are not comparable.
Page studyPage(const CaseResult &result);

} // namespace slidercrank
