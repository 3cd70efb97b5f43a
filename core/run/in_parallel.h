// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pieces of work that do not depend on each other, on all processors.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace slidercrank
{

/// Calls work(i) once for each i < count, in any order, on as many threads as there are processors, the caller's among
/// them, and returns when all is done; on the caller's alone where it is not `worthIt`. A thread costs some 20 us.
/// `work` does not throw.
template <class Work>
void inParallel(std::size_t count, const Work &work, bool worthIt = true)
{
    std::atomic<std::size_t> next = 0;
    const auto takeTurns = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            work(i);
        }
    };
    const std::size_t threads = worthIt ? std::max(1U, std::thread::hardware_concurrency()) : 1;
    std::vector<std::jthread> aside;
    for (std::size_t i = 1; i < std::min(threads, count); ++i) {
        aside.emplace_back(takeTurns);
    }
    takeTurns();
    aside.clear(); // waits for them
}

} // namespace slidercrank
