// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The streams of a command: the same bytes on every system, UTF-8 where a person reads them.

namespace slidercrank
{

/// To be called first. One that is closed would be the next file that is opened, and what is said would stand in it; a
/// file that has grown to its limit would be the end without a word.
void prepareStreams();

/// On Windows they are made so, on the console of whoever started the program where they go nowhere else.
void useConsole();

/// Leaves it as it was found: a window has nothing to do with it. At the end of the program at the latest.
void leaveConsole();

} // namespace slidercrank
