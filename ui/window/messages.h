// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slidercrank
{

class MainWindow;
class MessageBar;

/// Shows the messages of the window's session in the message bar from now on. A newer message replaces an older
/// one with the same id.
void showMessages(MainWindow *window, MessageBar *bar);

} // namespace slidercrank
