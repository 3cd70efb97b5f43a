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

/// Compares the speed of the closed form with that of dense Newton-Raphson at its default tolerance, both computing all
/// channels: "The closed form is 65 times as fast as dense Newton-Raphson with its default tolerance (± 8 %)." Returns
/// an empty string if one of the two was not measured.
QString closedFormSentence(const CaseResult &result);

/// Describes the machine and the compiler: "x86_64, 8 threads, GNU C++ 12.2.0".
QString machineText();

/// Returns the results as JSON.
QJsonObject studyJson(const StudyResult &result);

/// Returns the results for CSV, with a record for each case and method.
std::vector<Record> studyRecords(const StudyResult &result);

} // namespace slidercrank
