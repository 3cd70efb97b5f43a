// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/cases.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace slidercrank
{

/// Returns nominalCases() followed by hardCases().
inline std::vector<Case> allCases()
{
    std::vector<Case> cases = nominalCases();
    std::ranges::copy(hardCases(), std::back_inserter(cases));
    return cases;
}

} // namespace slidercrank
