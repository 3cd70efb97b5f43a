// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Runs independent pieces of work on all processors.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace slidercrank
{

/// The threads that inParallel() uses. Starting a thread takes about 20 µs.
enum class Threads {
    CallingThread,  ///< no other thread
    OnePerProcessor ///< as many threads as there are processors, the calling thread included
};

/// Calls work(i) once for each i < count, in any order, and returns when all calls have returned. If work() throws, the
/// exception is rethrown when all threads have ended.
template <class Work>
void inParallel(std::size_t count, const Work &work, Threads allowed = Threads::OnePerProcessor)
{
    std::atomic<std::size_t> next = 0;
    const auto doRemainingWork = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            work(i);
        }
    };
    const bool useSeveral = allowed == Threads::OnePerProcessor && count > 1;
    const std::size_t threadCount = useSeveral ? std::max(1U, std::thread::hardware_concurrency()) : 1;
    std::vector<std::future<void>> otherThreads; // destructors of futures wait for the threads, also after an exception
    try {
        for (std::size_t i = 1; i < std::min(threadCount, count); ++i) {
            otherThreads.push_back(std::async(std::launch::async, doRemainingWork));
        }
    } catch (const std::system_error &) { // no further thread can be started: the existing threads do all of the work
    }
    doRemainingWork();
    for (std::future<void> &thread : otherThreads) {
        thread.get();
    }
}

} // namespace slidercrank
