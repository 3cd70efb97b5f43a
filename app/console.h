// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Prepares the standard streams, so that a command writes the same bytes on every system.

namespace slidercrank
{

/// Must be called before any file is opened. Makes sure that no file gets the descriptor of a closed standard stream,
/// and that writing beyond the size limit of a file fails instead of ending the program.
void prepareStreams();

/// On Windows: switches the streams to binary mode and the console to UTF-8. Streams without a target are connected to
/// the console from which the program was started.
void useConsole();

/// On Windows: undoes useConsole(). Called before the window opens, and at the end of the program.
void leaveConsole();

} // namespace slidercrank
