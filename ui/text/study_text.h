// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the cases, the machine and the result of the study in the current language.

#include "core/study/study.h"

#include <QByteArray>
#include <QString>

#include <string>

namespace slidercrank
{

/// Returns the name of a case in the current language: "toggle gap 1e-4, crossed".
QString caseText(const std::string &name);

/// Compares the closed form with dense Newton-Raphson at the tolerance of the reference report, both computing all
/// channels: "Closed form: 65 (± 8 %) times faster than dense Newton-Raphson; largest error …". Returns an empty
/// string if one of the two was not measured.
QString closedFormSentence(const CaseResult &result);

/// Describes the machine and the compiler: "x86-64, 8 threads, GCC 12".
QString machineText(const Machine &machine);

/// Return the results as a file in UTF-8. A missing value is null in JSON and empty in CSV.
QByteArray studyJson(const StudyResult &result);
QByteArray studyCsv(const StudyResult &result);

} // namespace slidercrank
