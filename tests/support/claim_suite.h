// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Runs files of each kind through the program and prints one line for each kind. Environment variables:
//
//     SLIDERCRANK_CLAIM_KIND   runs only the kinds whose name contains this text
//     SLIDERCRANK_CLAIM_SEED   uses another seed
//     SLIDERCRANK_CLAIM_RUNS   number of files of each kind
//     SLIDERCRANK_CLAIM_FILE   runs only the file with this number
//     SLIDERCRANK_CLAIM_DIR    folder to which files with a false claim or a miss are written

#include "tests/support/claim_file.h"

namespace slidercrank
{

/// Sanitizer builds are thirty times slower and check memory, not numbers, so they run only a few files.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kIsMemoryCheck = true;
#else
inline constexpr bool kIsMemoryCheck = false;
#endif

struct ClaimTotals {
    int files = 0;
    int falseClaims = 0;
    int determined = 0; ///< files that determine their mechanism
    int missed = 0;     ///< determined files whose mechanism was not found
};

std::uint64_t claimSeed();

ClaimTotals runClaimSuite(std::span<const ClaimKind> kinds, int filesOfAKind);

} // namespace slidercrank
