// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Aborts a fuzz target if a condition does not hold.

#include <cstdio>
#include <cstdlib>

namespace slidercrank
{

inline void require(bool condition, const char *description)
{
    if (!condition) {
        std::fprintf(stderr, "Violated: %s\n", description);
        std::abort();
    }
}

} // namespace slidercrank
