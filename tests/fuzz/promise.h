// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What every fuzz target judges with: where a promise is broken, it ends there and then.

#include <cstdio>
#include <cstdlib>

namespace slidercrank
{

inline void require(bool holds, const char *what)
{
    if (!holds) {
        std::fprintf(stderr, "Broken promise: %s\n", what);
        std::abort();
    }
}

} // namespace slidercrank
