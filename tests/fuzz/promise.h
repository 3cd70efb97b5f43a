// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ends the program at once when a promise is broken, for all fuzz targets.

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
