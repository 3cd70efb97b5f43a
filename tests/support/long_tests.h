// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Random suites are short, unless SLIDERCRANK_LONG_TESTS=1 asks for many cases (tests/run --long).

#include <QtGlobal>

#include <algorithm>

namespace slidercrank
{

inline int runs(int usual, int many)
{
    return qEnvironmentVariableIntValue("SLIDERCRANK_LONG_TESTS") > 0 ? many : usual;
}

/// Of cases about numbers. The sanitizers, many times slower, look at memory: an eighth is enough for them.
inline int numericRuns(int usual, int many)
{
#ifdef __SANITIZE_ADDRESS__
    return runs(std::max(usual / 8, 1), many);
#else
    return runs(usual, many);
#endif
}

} // namespace slidercrank
