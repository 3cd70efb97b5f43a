// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What Qt and the window system take from the command line for themselves (a session manager's -session, a display's
// -display, -platform, -style, …): QApplication will take it out, but the line is read before there is one.

#include <QStringList>

namespace slidercrank
{

/// The program's own, its name first.
QStringList withoutWindowSystemOptions(const QStringList &arguments);

/// Whether they say where the window is to be.
bool choosesPlatform(const QStringList &arguments);

} // namespace slidercrank
