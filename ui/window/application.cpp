// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/application.h"

#include <new>

namespace slidercrank
{

bool Application::notify(QObject *receiver, QEvent *event)
{
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::bad_alloc &) {
        emit memoryEnded();
        return true;
    }
}

} // namespace slidercrank
