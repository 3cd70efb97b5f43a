// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the study's cases and its machine are called in the language in use, and what it comes to.

#include "core/study/study.h"

#include <QString>

namespace slidercrank
{

/// "toggle gap 1e-4, crossed".
QString caseText(const std::vector<CaseTrait> &traits);

/// "Closed form: 65 times as fast as the report's way and 4 times as exact here.": as measured, Newton-Raphson with the
/// report's tolerance against the closed form. Empty where one of them was not.
QString closedFormSentence(const CaseResult &which);

/// "x86-64, 8 threads, GCC 12".
QString machineText(const Machine &machine);

} // namespace slidercrank
