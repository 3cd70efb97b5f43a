// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Asks the user before something is replaced. Nothing waits for the answer in an event loop of its own: the program
// goes on, and what depends on the answer is called when it is given.

#include <QString>

#include <functional>

class QWidget;

namespace slidercrank
{

/// Opens a question with the answers Yes and No as a modal child of `parent` and returns at once. Calls `replace` if
/// the answer is Yes. The default answer is No.
void askBeforeReplacing(QWidget *parent, const QString &title, const QString &question,
                        const std::function<void()> &replace);

} // namespace slidercrank
