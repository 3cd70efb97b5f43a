// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Random suites are short, unless SLIDERCRANK_LONG_TESTS=1 asks for many cases (tests/run --long).

#include <QtGlobal>

namespace slidercrank
{

inline int runs(int usual, int many)
{
    return qEnvironmentVariableIntValue("SLIDERCRANK_LONG_TESTS") > 0 ? many : usual;
}

} // namespace slidercrank
