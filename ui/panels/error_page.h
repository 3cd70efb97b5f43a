// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far the model is from the reference file, or from the motion that was pinned last: a verdict, what explains the
// difference and how to remedy it, and a row for each channel.

#include "ui/document/result.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// `diagnosis`: may be null, or that of other parameters or of another file; then it is not used.
Page errorPage(const Result &result, const ReferenceDiagnosis *diagnosis);

/// What the file may mean and which mechanism it belongs to, unless every channel agrees; and the conventions applied.
std::vector<Finding> findingsOf(const Result &result, const ReferenceDiagnosis *diagnosis);

/// "Errors ✗": the title of the tab, with the mark of the verdict on the file.
QString errorTitle(const Result &result);

/// Whether the diagnosis is of the file on show, and of the parameters on show.
bool isOfFile(const ReferenceDiagnosis *diagnosis, const Result &result);
bool isUpToDate(const ReferenceDiagnosis *diagnosis, const Result &result);

/// A table of the parameters now and with the mechanism found, as rich text.
QString changesText(const Parameters &before, const Diagnosis &diagnosis);

} // namespace slidercrank
