// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Runs kinds of files through the program and prints a line for each kind.
//
//     SLIDERCRANK_CLAIM_KIND   only the kinds whose name contains this
//     SLIDERCRANK_CLAIM_SEED   another suite of files
//     SLIDERCRANK_CLAIM_RUNS   number of files of each kind
//     SLIDERCRANK_CLAIM_FILE   only the file of that number
//     SLIDERCRANK_CLAIM_DIR    where the files with a false claim or a miss are written

#include "tests/support/claim_file.h"

namespace slidercrank
{

/// The sanitizers, thirty times slower, look at memory and not at numbers: a few files are enough for them.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kIsMemoryCheck = true;
#else
inline constexpr bool kIsMemoryCheck = false;
#endif

struct ClaimTotals {
    int files = 0;
    int falseClaims = 0;
    int determined = 0; ///< files that determine their mechanism
    int missed = 0;     ///< of these
};

std::uint64_t claimSeed();

ClaimTotals runClaimSuite(std::span<const ClaimKind> kinds, int filesOfAKind);

} // namespace slidercrank
