// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A disk that fails: of the calls by which a process changes files in one folder, and below it, the one asked for fails
// once, or is the last that the process makes. Linked to a test this is about its own calls; preloaded, about those of
// a program that finds in its environment what is asked for. Linux alone.

namespace slidercrank
{

/// SLIDERCRANK_FAILING_FOLDER; SLIDERCRANK_FAILING_CALL: which, from 1; SLIDERCRANK_FAILING_END: "kill", or the file
/// that is made when the call failed.
inline constexpr char kFailingFolder[] = "SLIDERCRANK_FAILING_FOLDER";
inline constexpr char kFailingCall[] = "SLIDERCRANK_FAILING_CALL";
inline constexpr char kFailingEnd[] = "SLIDERCRANK_FAILING_END";

} // namespace slidercrank

extern "C" {
/// From here on; `which` of 0: none.
void failCall(const char *folder, int which);
bool hasFailed();
}
