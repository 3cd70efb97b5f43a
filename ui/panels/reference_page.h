// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/result.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// Returns a page about the reference file: the meaning of each column, the skipped rows, and the mechanism found in
/// the file. `identification` is used only if it belongs to this file; it may be null.
Page referencePage(const Result &result, const ReferenceIdentification *identification);

} // namespace slidercrank
