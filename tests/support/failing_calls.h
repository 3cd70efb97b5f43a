// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Simulates a failing disk. Of the system calls by which a process changes files in or below a folder, the selected one
// fails once or kills the process. A test links this file to make its own calls fail. A program that preloads it is
// killed at the call that environment variables select. Linux only.

namespace slidercrank
{

/// Names of the environment variables: the folder, and the number of the call that kills the process (from 1).
inline constexpr char kFailingFolder[] = "SLIDERCRANK_FAILING_FOLDER";
inline constexpr char kFailingCall[] = "SLIDERCRANK_FAILING_CALL";

} // namespace slidercrank

extern "C" {
/// Makes call `number` fail, counted from now on. With 0, no call fails.
void failCall(const char *folder, int number);
/// Returns whether the selected call has failed.
bool hasFailed();
}
