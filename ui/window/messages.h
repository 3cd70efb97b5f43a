// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slidercrank
{

class MainWindow;
class MessageBar;

/// Shows the messages of the window's session in the message bar from now on. Each message has a subject; a newer
/// message with the same subject replaces it.
void showMessages(MainWindow *window, MessageBar *bar);

} // namespace slidercrank
