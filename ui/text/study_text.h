// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the cases, the machine and the result of the study in the current language.

#include "core/study/study.h"
#include "ui/text/record.h"

#include <QString>

#include <string>

namespace slidercrank
{

/// Returns the name of a case in the current language: "toggle gap 1e-4, crossed".
QString caseText(const std::string &name);

/// Compares the closed form with dense Newton-Raphson at the tolerance of the reference report, both computing all
/// channels: "Closed form: 65 times as fast as dense Newton-Raphson (± 8 %); largest error …". Returns an empty
/// string if one of the two was not measured.
QString closedFormSentence(const CaseResult &result);

/// Describes the machine and the compiler: "x86_64, 8 threads, GNU C++ version 12.2.0".
QString machineText();

/// Return the results for files in JSON, and for files in CSV with a record for each case and method.
QJsonObject studyJson(const StudyResult &result);
std::vector<Record> studyRecords(const StudyResult &result);

} // namespace slidercrank
