// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The number of random cases: few by default, many if SLIDERCRANK_LONG_TESTS=1 (tests/run --long).

#include <QtGlobal>

#include <algorithm>

namespace slidercrank
{

/// Sanitizer builds are many times slower and need much memory.
#ifdef SLIDERCRANK_SANITIZED
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

/// Returns whether SLIDERCRANK_LONG_TESTS asks for the long tests.
inline bool areTestsLong()
{
    return qEnvironmentVariableIntValue("SLIDERCRANK_LONG_TESTS") > 0;
}

/// Returns the number of cases: `usual`, or `many` in long tests.
inline int caseCount(int usual, int many)
{
    return areTestsLong() ? many : usual;
}

/// Returns the number of cases of a numerical test. Sanitizer builds check memory, not numbers, so that an eighth of
/// the usual number is enough for them.
inline int numericCaseCount(int usual, int many)
{
    return caseCount(kIsSanitized ? std::max(usual / 8, 1) : usual, many);
}

} // namespace slidercrank
