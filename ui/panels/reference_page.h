// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/result.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// What was read from the reference file and how: a row for each column, the rows left out, the mechanism found in it.
/// `diagnosis`: may be null, or of another file; then it is not used.
Page referencePage(const Result &result, const ReferenceDiagnosis *diagnosis);

} // namespace slidercrank
