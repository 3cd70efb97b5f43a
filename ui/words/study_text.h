// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the study's cases and its machine are called in the language in use.

#include "core/study/study.h"

#include <QString>

namespace slidercrank
{

/// "toggle gap 1e-4, crossed".
QString caseText(const std::vector<CaseTrait> &traits);

/// "x86-64, 8 threads, GCC 12".
QString machineText(const Machine &machine);

} // namespace slidercrank
