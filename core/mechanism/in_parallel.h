// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pieces of work that do not depend on each other, on all processors.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace slidercrank
{

/// Calls work(i) once for each i < count, in any order, on as many threads as there are processors, the caller's among
/// them, and returns when all is done; on the caller's alone where it is not `worthIt`. A thread costs some 20 us.
/// Where work throws (no memory), this does, when all threads have ended.
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
    std::vector<std::future<void>> aside; // waited for, whatever happens here
    try {
        for (std::size_t i = 1; i < std::min(threads, count); ++i) {
            aside.push_back(std::async(std::launch::async, takeTurns));
        }
    } catch (const std::system_error &) { // no more threads to be had: these do it all
    }
    takeTurns();
    for (std::future<void> &other : aside) {
        other.get();
    }
}

} // namespace slidercrank
