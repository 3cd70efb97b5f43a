// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the study's cases and its machine are called in the language in use, and what it comes to.

#include "core/study/study.h"

#include <QString>

#include <string>

namespace slidercrank
{

/// A case's name in the language in use: "toggle gap 1e-4, crossed".
QString caseText(const std::string &name);

/// "Closed form: 65 times as fast (60 to 70) as the report's way and 4 times as exact here.": as measured,
/// Newton-Raphson with the tolerance of the reference report against the closed form; both compute all channels. Errors
/// below the rounding of the data are not compared. Empty where one of them was not measured.
QString closedFormSentence(const CaseResult &which);

/// "x86-64, 8 threads, GCC 12".
QString machineText(const Machine &machine);

/// The files of a study, UTF-8 with Unix line ends. What does not exist is null in JSON, empty in CSV.
std::string studyJson(const StudyResult &result);
std::string studyCsv(const StudyResult &result);

} // namespace slidercrank
