// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The page of the errors of the model against the reference file, or against the motion that was pinned last: a
// verdict, explanations of the difference with their remedies, and a row for each channel.

#include "ui/document/result.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// `identification` may be null; otherwise it is used only if it belongs to the current file.
Page errorPage(const Result &result, const ReferenceIdentification *identification);

/// Returns a finding for each explanation of the differences, with its remedy, unless every channel agrees; and one
/// that lists the conventions that are applied to the file, if there are any. Requires a reference.
std::vector<Finding> findingsOf(const Result &result, const ReferenceIdentification *identification);

/// Returns the title of the tab with the mark of the verdict on the file: "Errors ✗".
QString errorTitle(const Result &result);

/// Returns whether the identification is that of the reference in `result`. It may have been made for earlier
/// parameters.
bool belongsToCurrentFile(const ReferenceIdentification *identification, const Result &result);

/// Returns the finding of a page that is empty because no file is open: the sentence, and a button that opens a file.
Finding noOpenFileFinding(const QString &sentence);

/// Adds the remedy to use the mechanism that was found, with the conventions of the file, if one was found and it is
/// not the given one.
void offerMechanism(Finding &finding, const Identification &found, const Parameters &given);

} // namespace slidercrank
