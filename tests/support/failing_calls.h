// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Simulates a failing disk. Of the system calls by which a process changes files in or below a folder, the selected one
// fails once or kills the process. A test links this file to make its own calls fail. A program preloads it and selects
// the call by environment variables. Linux only.

namespace slidercrank
{

/// Names of the environment variables: the folder, the number of the call that fails (from 1), and "kill" or the path
/// of a file that is created when the call has failed.
inline constexpr char kFailingFolder[] = "SLIDERCRANK_FAILING_FOLDER";
inline constexpr char kFailingCall[] = "SLIDERCRANK_FAILING_CALL";
inline constexpr char kFailingEnd[] = "SLIDERCRANK_FAILING_END";

} // namespace slidercrank

extern "C" {
/// Makes call `number` fail, counted from now on. With 0, no call fails.
void failCall(const char *folder, int number);
/// Returns whether the selected call has failed.
bool hasFailed();
}
